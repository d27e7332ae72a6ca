// Free cells past iteration 2^31: births and ages as the reference has them, up to the last iteration.
#include "core/prepattern.hpp"
#include "reference/backend.hpp"
#include "support/free_cells.hpp"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace pelage;

namespace {

// Cells divide, age, and tell in U which comparisons of whole numbers held.
const char* const ageing = R"(
define chemical U
define chemical V
use chemical U conc 1 dev 0.5 diff 0.02
create hex_grid 6 6
rule if AGE == 3 divide direction BIRTH
rule if BIRTH > 2147483649 change U conc 0.5
rule if AGE >= 2147483648.5 change U conc 0.25
rule if BIRTH == 16777217 change U conc 0.125
rule if AGE in 16777217 BIRTH change U conc 0.0625
rule if ITERATION in 4294967290 4294967291 change U conc 8
rule if NEIGHBORS <= 5.5 change U conc 0.03125
rule always change V conc AGE
)";

Snapshot late(const Experiment& experiment, std::uint64_t iteration) {
    constexpr std::uint32_t births[] = {0, 16777216, 16777217, 2147483647, 2147483648, 2147483649};
    Snapshot state = initial_state(experiment);
    state.iteration = iteration;
    for (std::size_t cell = 0; cell < state.cells(); ++cell) {
        state.birth[cell] = cell % 7 < 6 ? births[cell % 7] : static_cast<std::uint32_t>(iteration);
    }
    return state;
}

}  // namespace

TEST_CASE("free cells: births and ages are right past iteration 2^31, up to the last one") {
    const std::uint64_t first = GENERATE(2147483649u, 4294967280u);
    const Precision precision = GENERATE(Precision::single_, Precision::double_);
    CAPTURE(first);
    const auto experiment = test::experiment(ageing);
    const auto expected = reference_backend(precision)->make_tissue(*experiment, late(*experiment, first));
    const auto found = test::on_device(experiment, {}, precision);
    found->write(late(*experiment, first));

    expected->advance(15);
    found->advance(15);

    const Snapshot end = expected->read();
    CHECK(end.cells() > 36);
    CHECK(std::ranges::max(end.birth) > first + 3);
    CHECK(test::difference(end, found->read()) == test::no_difference);
    if (first != 4294967280u) return;
    CHECK(end.iteration == largest_iteration);
    CHECK_THROWS(found->advance(1));
}
