// The built-in reactions, written as formulas.
#include "core/models.hpp"
#include "core/prepattern.hpp"
#include "language/parse.hpp"
#include "opencl/backend.hpp"
#include "reference/backend.hpp"

#include <catch2/catch.hpp>

#include <iterator>
#include <string>

using namespace pelage;

TEST_CASE("The built-in reactions written as formulas agree with them to rounding") {
    const std::string world =
        "define chemical U\ndefine chemical V\ndefine time_step 0.01\nuse chemical U conc 2 dev 0.75 diff 0.5\n"
        "use chemical V conc 1 dev 0.25 diff 0.25\ncreate matrix 32 32 wrap\nstop at 50\nrule always react ";
    const std::pair<const char*, const char*> all[] = {
        {"U V turing alpha 16 beta 12", "U by (16 - U * V) V by (U * V - V - 12)"},
        {"U V gray-scott f 0.04 k 0.06", "U by (-U * V ^ 2 + 0.04 * (1 - U)) V by (U * V ^ 2 - (0.04 + 0.06) * V)"},
        {"U V linear au 0.5 bu -0.25 cu 1 du 0.25 mu 2 av 0.5 bv 0.25 cv 0 dv 0.5 mv 3",
         "U by (clamp(0.5 * U - 0.25 * V + 1, 0, 2) - 0.25 * U) V by (clamp(0.5 * U + 0.25 * V, 0, 3) - 0.5 * V)"},
        {"U V gm1 a 0.1 b 0.5 c 0.25", "U by (0.1 - 0.5 * U + U ^ 2 / (V * (1 + 0.25 * U ^ 2))) V by (U ^ 2 - V)"},
        {"U V cubic a 1 b 2 c 3", "U by ((U - 1) * (U - 2) * (U - 3))"},
        {"U reinforcement threshold 3.5 width 0.5",
         "U by ((3.5 - 0.5 - U) * (3.5 - U) * (3.5 + 0.5 - U) * 3 * sqrt(3) / (2 * 0.5 ^ 2))"}};
    REQUIRE(std::size(all) == model_table().size());
    for (const auto& [word, formula] : all) {
        INFO(formula);
        const Experiment by_word = parse_experiment(world + word, "word.pex", ".");
        const Experiment by_formula = parse_experiment(world + formula, "formula.pex", ".");
        const Snapshot initial = initial_state(by_word);
        const auto one = reference_backend(Precision::single_)->make_tissue(by_word, initial);
        const auto other = opencl_backend({})->make_tissue(by_formula, initial);
        one->advance(50);
        other->advance(50);
        const Snapshot a = one->read(), b = other->read();
        for (std::size_t chemical = 0; chemical < 2; ++chemical) {
            for (std::size_t cell = 0; cell < a.cells(); ++cell)
                REQUIRE(a.conc[chemical][cell] == Approx(b.conc[chemical][cell]).epsilon(2e-5).margin(1e-6));
        }
    }
}
