// See check.hpp: free cells, step by step against the reference.
#include "core/prepattern.hpp"
#include "language/parse.hpp"
#include "reference/backend.hpp"
#include "verify/bounded.hpp"
#include "verify/cases_cells.hpp"
#include "verify/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <string_view>

namespace pelage::verify {

namespace {

constexpr std::uint64_t iterations = 40;
constexpr std::uint64_t stride = 8;
constexpr std::uint64_t iterations_if_small = 3;
// Others are left to the generated ones.
constexpr std::array<std::string_view, 2> quick_cell_cases{"cells/at-one-place", "cells/divide-while-polarized"};

bool quick(const std::string& name) {
    return std::ranges::find(quick_cell_cases, std::string_view(name)) != quick_cell_cases.end();
}

void follow(Outcome& outcome, const std::vector<Snapshot>& expected, const Experiment& experiment,
            const Snapshot& initial, Place& place, const Setting& setting, const std::string& where) {
    const auto tissue = place.backend(setting).make_tissue(experiment, initial);
    for (const Snapshot& state : expected) {
        tissue->advance(state.iteration - tissue->iteration());
        const std::string when = fmt::format("{}iteration {}", where.empty() ? "" : where + ", ", state.iteration);
        add(outcome.tally, state, tissue->read(), setting.precision, when);
    }
}

std::vector<Snapshot> by_reference(const Experiment& experiment, const Snapshot& initial, const Setting& setting,
                                   std::uint64_t last) {
    const auto tissue = reference_backend(setting.precision, setting.search)->make_tissue(experiment, initial);
    std::vector<Snapshot> states;
    for (std::uint64_t done = 0; done < last; done += stride) {
        tissue->advance(std::min(stride, last - done));
        states.push_back(tissue->read());
    }
    return states;
}

bool moved_on(const Snapshot& before, const Snapshot& after) {
    return after.cells() != before.cells() || after.x != before.x || after.conc != before.conc ||
           after.polarity_x != before.polarity_x;
}

std::vector<Setting> settings_of(const Place& place) {
    std::vector<Setting> settings{{}, {.path = Path::shared}, {.guarded = false}};  // the first twice
    const std::size_t group = std::min<std::size_t>(5, place.device().max_work_group);
    if (!place.full()) return settings;
    settings.push_back({.work_group = group, .width = 1});
    settings.push_back({.path = Path::shared, .work_group = group, .width = 1});
    if (!place.device().fp64) return settings;
    settings.push_back({.precision = Precision::double_});
    settings.push_back({.precision = Precision::double_, .path = Path::shared});
    return settings;
}

using Touch = std::function<void(Snapshot&)>;

// `touch` changes the start of the experiment.
Outcome check_cells(const CellCase& one, Place& place, const std::vector<Setting>& settings, const Touch& touch = {}) {
    Outcome outcome;
    const Experiment experiment = place.seeded(parse_experiment(one.text(), one.name, "."));
    Snapshot initial = initial_state(experiment);
    if (touch) touch(initial);
    const std::uint64_t last = place.small() ? iterations_if_small : iterations;
    const std::size_t count = std::min<std::size_t>(place.small() ? 2 : settings.size(), settings.size());
    std::vector<Snapshot> states{initial};
    for (std::size_t i = 0; i < count; ++i) {
        const auto expected = by_reference(experiment, initial, settings[i], last);
        if (i == 0) states.insert(states.end(), expected.begin(), expected.end());
        if (!moved_on(initial, expected.back())) {
            outcome.verdict = Verdict::mistrusted;
            outcome.message = "the reference ends as it began";
        }
        follow(outcome, expected, experiment, initial, place, settings[i], settings[i].text());
    }
    conclude_bounded(outcome, experiment, states, place, settings.front());
    return outcome;
}

const CellCase mirror_pairs{"cells/mirror-pairs",
                            "rule always react A B scale 0.01 turing alpha 16 beta 12\nrule probability 0.02 divide\n"};

const CellCase& case_named(std::string_view name) { return *std::ranges::find(cell_cases(), name, &CellCase::name); }

// Cells of all ages, so late that neither int nor float holds them.
const CellCase late{"cells/last-iterations",
                    "rule if AGE > 2147483648.5 change A conc 0.25\nrule if BIRTH == 2147483649 change B conc 0.5\n"
                    "rule if BIRTH < AGE change C conc 0.125\nrule if ITERATION == 4294967255 change B conc 1\n"
                    "rule if AGE == 2 divide direction 45\n"};

void make_late(Snapshot& state) {
    state.iteration = largest_iteration - iterations;
    for (std::size_t cell = 0; cell < state.cells(); ++cell) {
        const std::uint32_t births[] = {0, 2147483649u, static_cast<std::uint32_t>(state.iteration)};
        state.birth[cell] = births[cell % 3];
    }
}

// Cells whose values are averaged after each step.
void pair_cells(Snapshot& state) { state.mirrors = {{0, 12}, {1, 11}, {11, 2}, {100, 5}, {5, 12}}; }

// Cells that touch nobody, until some divide: by then many steps are enqueued together.
const CellCase resting{"cells/divide-after-rest",
                       "rule always change A conc 0.01\nrule from 25 probability 0.02 divide direction 45\n"};

// Lists are mended around few children, again and again in one launch.
const CellCase sparing{"cells/divide-now-and-then",
                       "rule always change A conc 0.01\nrule probability 0.002 divide direction 45\n"};

void spread_out(Snapshot& state) {
    constexpr std::size_t across = 16;
    for (std::size_t cell = 0; cell < state.cells(); ++cell) {
        state.x[cell] = 5.0 * static_cast<double>(cell % across);
        state.y[cell] = 5.0 * static_cast<double>(cell / across);
    }
}

// Subnormal numbers, in and out: values about the smallest normal number, some of them below it.
Outcome cells_near_zero(Place& place) {
    const std::string& why_not = place.subnormal_difference();
    if (!why_not.empty()) return {Verdict::skipped, {}, why_not, {}};
    const CellCase one{"cells/near-zero",
                       "rule always react A B scale 0.1 gray-scott f 0 k 0.06\nrule if C conc < 1e-40 polarize A conc\n"
                       "rule always change C conc -1e-39\n"};
    return check_cells(one, place, {{}}, [](Snapshot& state) {
        for (auto& plane : state.conc) {
            for (double& value : plane) value = (value - 1) * 0x1p-126;
        }
    });
}

// More cells than 16 bits count, the last of them born in the run, with draws for each; and a limit of neighbours, too.
constexpr const char* crowd_of_cells = R"(
define division_limit 65539
define chemical A limit 6
define chemical B
use seed 5
use chemical A conc 3 dev 2 diff 0.05 dev 0.02
use chemical B conc 1 dev 1
use polarity 30 dev 170
create hex_grid 260 252 dev 0.3
rule always map A conc 0 6 to M 0 1
rule always change B conc RANDOM dev 0.25
rule if RANDOM < 0.25 move 0.05 dev 0.05
rule probability 0.01 divide direction M dev 120
)";

struct Stretch {
    const Experiment& experiment;
    Snapshot from;
    std::uint64_t iterations;
};

// What the reference has in the end.
Snapshot many_more(Outcome& outcome, Place& place, const Setting& setting, const Stretch& stretch) {
    const auto& [experiment, from, iterations_more] = stretch;
    const auto expected = reference_backend(setting.precision, setting.search)->make_tissue(experiment, from);
    const auto found = place.backend(setting).make_tissue(experiment, from);
    expected->advance(iterations_more);
    found->advance(iterations_more);
    const Snapshot there = expected->read();
    add(outcome.tally, there, found->read(), setting.precision,
        fmt::format("{}iteration {}", setting.text().empty() ? "" : setting.text() + ", ", there.iteration));
    return there;
}

Outcome many_cells(Place& place) {
    if (place.small()) return {Verdict::skipped, {}, "left out with --small", {}};
    Outcome outcome;
    const Experiment experiment = place.seeded(parse_experiment(crowd_of_cells, "many cells", "."));
    const Snapshot initial = initial_state(experiment);
    const Setting by_bins, together{.path = Path::shared}, by_sorting{.search = NeighbourSearch::spatial_sorting};
    std::vector<Snapshot> states{initial};
    for (const std::uint64_t count : {1u, 2u}) {
        const Snapshot& before = states.back();
        states.push_back(many_more(outcome, place, by_bins, {experiment, before, count}));
    }
    many_more(outcome, place, together, {experiment, initial, 1});
    many_more(outcome, place, by_sorting, {experiment, initial, 1});
    if (states.back().cells() == initial.cells()) return {Verdict::mistrusted, {}, "no cell divides", {}};
    conclude_bounded(outcome, experiment, states, place, {});
    return outcome;
}

}  // namespace

std::vector<Check> cell_checks() {
    std::vector<Check> checks;
    for (const CellCase& one : cell_cases()) {
        const auto run = [&one](Place& place) { return check_cells(one, place, settings_of(place)); };
        checks.push_back({one.name, one.divides() ? "division" : "cell step", quick(one.name), run});
    }
    checks.push_back({"cells/mirror-pairs", "cell step", false, [](Place& place) {
                          return check_cells(mirror_pairs, place, {{}, {.path = Path::shared}}, pair_cells);
                      }});
    checks.push_back({late.name, "cell step", false,
                      [](Place& place) { return check_cells(late, place, settings_of(place), make_late); }});
    checks.push_back({"cells/spatial-sorting", "neighbour search", true, [](Place& place) {
                          return check_cells(mirror_pairs, place, {{.search = NeighbourSearch::spatial_sorting}});
                      }});
    checks.push_back({"cells/spatial-sorting-at-one-place", "neighbour search", false, [](Place& place) {
                          return check_cells(case_named("cells/at-one-place"), place,
                                             {{.search = NeighbourSearch::spatial_sorting}});
                      }});

    checks.push_back({resting.name, "division", true,
                      [](Place& place) { return check_cells(resting, place, {{.path = Path::step}}, spread_out); }});
    checks.push_back({sparing.name, "division", true,
                      [](Place& place) { return check_cells(sparing, place, {{.path = Path::shared}}, spread_out); }});
    checks.push_back({"cells/near-zero", "special values", true, cells_near_zero});
    checks.push_back({"cells/many", "division", true, many_cells});
    return checks;
}

}  // namespace pelage::verify
