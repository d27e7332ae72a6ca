// One chemical's amounts, read alone: those of the whole state, on either backend.
#include "core/prepattern.hpp"
#include "language/parse.hpp"
#include "opencl/backend.hpp"
#include "reference/backend.hpp"

#include <catch2/catch.hpp>

#include <memory>
#include <string>
#include <vector>

using namespace pelage;

namespace {

const std::string growing_spots =
    "define chemical U\ndefine chemical V\ndefine time_step 0.01\n"
    "use chemical U conc 4 dev 1 diff 5\nuse chemical V conc 4 dev 1 diff 1\n"
    "create matrix 21 13 wrap\n"
    "rule always react U V turing alpha 16 beta 12\n"
    "rule every 3 always expand columns 2 rows 1\n";

const std::string swarm =
    "define chemical U\ndefine chemical V\nuse chemical U conc 1 dev 0.5 diff 0.1\nuse chemical V conc 2 dev 0.5\n"
    "create hex_grid 6 5\nrule probability 0.2 divide direction 0 dev 180\n";

void check_alone(Backend& backend, const std::string& text) {
    const Experiment experiment = parse_experiment(text, "test.pex", ".");
    const auto tissue = backend.make_tissue(experiment, initial_state(experiment, backend.precision()));
    std::vector<float> found(3, -1.0F);
    for (const std::uint64_t iterations : {0U, 1U, 6U}) {
        tissue->advance(iterations);
        const Snapshot whole = tissue->read();
        for (std::size_t chemical = 0; chemical < 2; ++chemical) {
            INFO(backend.name() << ", iteration " << whole.iteration << ", chemical " << chemical);
            tissue->read_conc(chemical, found);
            CHECK(found == std::vector<float>(whole.conc[chemical].begin(), whole.conc[chemical].end()));
        }
    }
    CHECK_THROWS_WITH(tissue->read_conc(2, found), "chemical 2 cannot be read; there are 2");
}

}  // namespace

TEST_CASE("a chemical's amounts are read alone as they are read with all else") {
    const auto precision = GENERATE(Precision::single_, Precision::double_);
    OpenclOptions options;
    options.precision = precision;
    for (const std::string& text : {growing_spots, swarm}) {
        check_alone(*reference_backend(precision), text);
        check_alone(*opencl_backend(options), text);
    }
}
