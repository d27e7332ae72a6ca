// Mappings that no active rule writes keep their values while others are written.
#include "core/prepattern.hpp"
#include "language/parse.hpp"
#include "opencl/backend.hpp"
#include "reference/backend.hpp"
#include "verify/compare.hpp"

#include <catch2/catch.hpp>

using namespace pelage;

TEST_CASE("A mapping outlives its rule while another one is written") {
    const Experiment experiment = parse_experiment(
        "define chemical U\n"
        "use chemical U conc 2 dev 1 diff 0.1\n"
        "create matrix 19 11\n"
        "define time_step 0.02\n"
        "rule until 9 always map X -9 9 to kept 1 -1\n"
        "rule always map U conc 0 5 to written 1 -1\n"
        "rule from 20 if kept < 0 change U conc 0.01\n",
        "mappings.pex", ".");
    const Snapshot initial = initial_state(experiment);
    OpenclOptions options;
    options.path = GENERATE(Path::streamed, Path::shared, Path::step);
    const auto expected = reference_backend(Precision::single_)->make_tissue(experiment, initial);
    const auto found = opencl_backend(options)->make_tissue(experiment, initial);

    for (int iteration = 1; iteration <= 24; ++iteration) {
        expected->advance(1);
        found->advance(1);
        // As a resumed run: only the state's own buffers hold what has been.
        if (iteration >= 14) found->write(found->read());

        INFO("after iteration " << iteration);
        REQUIRE(verify::differences(expected->read(), found->read()).empty());
    }
}
