// See free_cells.hpp.
#include "support/free_cells.hpp"

#include "core/prepattern.hpp"
#include "language/parse.hpp"
#include "reference/cells.hpp"
#include "support/opencl_session.hpp"
#include "support/shared.hpp"

#include <fmt/format.h>
#include <catch2/catch.hpp>

#include <algorithm>
#include <bit>

using namespace pelage;

namespace test {

namespace {

template <class V>
std::string differing(const std::string& what, const std::vector<V>& expected, const std::vector<V>& found) {
    if (expected.size() != found.size()) {
        return fmt::format("{}: {} values, expected {}", what, found.size(), expected.size());
    }
    std::size_t count = 0;
    std::size_t first = 0;
    for (std::size_t i = expected.size(); i-- > 0;) {
        bool same = expected[i] == found[i];
        if constexpr (std::is_same_v<V, double>) {
            same = std::bit_cast<std::uint64_t>(expected[i]) == std::bit_cast<std::uint64_t>(found[i]);
        }
        if (same) continue;
        ++count;
        first = i;
    }
    if (count == 0) return "";
    return fmt::format("{} of cell {}: {}, expected {} ({} of {} differ)", what, first, found[first], expected[first],
                       count, expected.size());
}

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
    std::vector<std::string> all{expected.iteration == found.iteration ? "" : "iteration",
                                 differing("x", expected.x, found.x),
                                 differing("y", expected.y, found.y),
                                 differing("polarity x", expected.polarity_x, found.polarity_x),
                                 differing("polarity y", expected.polarity_y, found.polarity_y),
                                 differing("birth", expected.birth, found.birth),
                                 differing("neighbours", expected.neighbours, found.neighbours),
                                 differing("fixed", expected.fixed, found.fixed),
                                 expected.mirrors == found.mirrors ? "" : "mirrors"};
    const auto planes = [&](const std::string& what, const auto& a, const auto& b) {
        if (a.size() != b.size()) all.push_back("number of " + what);
        for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
            all.push_back(differing(fmt::format("{} {}", what, i), a[i], b[i]));
        }
    };
    planes("conc", expected.conc, found.conc);
    planes("diff", expected.diff, found.diff);
    planes("mapping", expected.mappings, found.mappings);
    const auto first = std::ranges::find_if(all, [](const std::string& text) { return !text.empty(); });
    return first == all.end() ? "" : *first;
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
