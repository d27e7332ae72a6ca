// See free_cells.hpp.
#include "support/free_cells.hpp"

#include "core/prepattern.hpp"
#include "language/parse.hpp"
#include "reference/cells/tissue.hpp"
#include "support/opencl_session.hpp"
#include "support/shared.hpp"
#include "verify/compare.hpp"
#include "verify/equal_runs.hpp"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace pelage;

namespace test {

namespace {

std::shared_ptr<const Session> shared_session(Precision precision) {
    return {std::shared_ptr<const Session>(), &session(precision)};  // lives as long as the program
}

}  // namespace

std::shared_ptr<const Experiment> experiment(const std::string& text) {
    return std::make_shared<const Experiment>(parse_experiment(text, "test.pex", "."));
}

std::shared_ptr<const Experiment> experiment_file(const std::string& below_shared) {
    return std::make_shared<const Experiment>(parse_experiment_file(shared(below_shared)));
}

std::unique_ptr<Tissue> on_reference(std::shared_ptr<const Experiment> what, Precision precision) {
    const Snapshot initial = initial_state(*what);
    return make_reference_cells(std::move(what), initial, precision);
}

std::unique_ptr<Tissue> on_device(std::shared_ptr<const Experiment> what, const CellsOptions& options,
                                  Precision precision) {
    const Snapshot initial = initial_state(*what);
    return make_opencl_cells(shared_session(precision), std::move(what), initial, options);
}

std::string difference(const Snapshot& expected, const Snapshot& found) {
    Snapshot a = expected;
    Snapshot b = found;
    verify::drop_shared_nans(a, b);
    const std::vector<std::string> lines = verify::differences(a, b);
    return lines.empty() ? no_difference : lines.front();
}

void check_equal_runs(Tissue& expected, Tissue& found, std::uint64_t iterations, std::uint64_t stride) {
    const Snapshot start = expected.read();
    REQUIRE(difference(start, found.read()) == no_difference);

    for (std::uint64_t done = 0; done < iterations; done += stride) {
        expected.advance(std::min(stride, iterations - done));
        found.advance(std::min(stride, iterations - done));
        INFO("after iteration " << expected.iteration());
        REQUIRE(difference(expected.read(), found.read()) == no_difference);
    }

    Snapshot end = expected.read();
    end.iteration = start.iteration;
    CHECK(difference(start, end) != no_difference);
}

}  // namespace test
