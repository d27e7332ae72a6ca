// See check.hpp: what is read of a tissue beside its whole state: one chemical, as films do, and how many neighbours
// spatial sorting misses.
#include "core/prepattern.hpp"
#include "core/searching.hpp"
#include "language/parse.hpp"
#include "reference/backend.hpp"
#include "verify/bounded.hpp"
#include "verify/cases.hpp"
#include "verify/cases_cells.hpp"
#include "verify/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace pelage::verify {

namespace {

constexpr std::uint64_t before_reading = 3;

void read_each(Outcome& outcome, Place& place, const Experiment& experiment, Precision precision) {
    const auto tissue = place.backend({.precision = precision}).make_tissue(experiment, initial_state(experiment));
    tissue->advance(before_reading);
    const Snapshot state = tissue->read();
    std::vector<float> values(7, -1.0f);  // what was there before must not stay
    for (std::size_t chemical = 0; chemical < state.conc.size(); ++chemical) {
        std::vector<float> expected;
        std::ranges::transform(state.conc[chemical], std::back_inserter(expected),
                               [](double value) { return static_cast<float>(value); });
        tissue->read_conc(chemical, values);
        if (values.size() != expected.size()) {
            outcome.verdict = Verdict::failed;
            outcome.message = fmt::format("{} values of {} cells", values.size(), expected.size());
            return;
        }
        add(outcome.tally, expected, values, fmt::format("chemical {} of {} cells", chemical, expected.size()));
    }
}

// Double precision makes programs of its own, which the quick form does without.
std::vector<Precision> precisions_for(const Place& place) {
    if (!place.full() || !place.device().fp64) return {Precision::single_};
    return {Precision::single_, Precision::double_};
}

Outcome one_chemical(Place& place) {
    const Size flat = place.small() ? Size{19, 11} : Size{37, 26}, deep{7, 6, 5};
    Outcome outcome;
    for (const Precision precision : precisions_for(place)) {
        for (const char* const name : {"reaction/fused", "reaction/published"})
            read_each(outcome, place, lattice_case(name).experiment(flat), precision);
        read_each(outcome, place, lattice_case("volume/diffusion/seven-point/wrap").experiment(deep), precision);
    }
    const std::string cells = cell_cases().front().text();
    read_each(outcome, place, parse_experiment(cells, "cells that are read", "."), Precision::single_);
    conclude(outcome);
    return outcome;
}

std::vector<double> numbers_of(const SearchStatistics& found) {
    std::vector<double> numbers;
    for (const std::uint64_t count : {found.iterations, found.cells, found.neighbours_exact, found.neighbours_missed,
                                      found.cells_with_misses, found.most_missed})
        numbers.push_back(static_cast<double>(count));
    return numbers;
}

Outcome missed_neighbours(Place& place) {
    Outcome outcome;
    const Experiment experiment = parse_experiment(cell_cases().front().text(), "cells that are sorted", ".");
    std::uint64_t most = 0;
    for (const Precision precision : precisions_for(place)) {
        const Setting sorting{.precision = precision, .search = NeighbourSearch::spatial_sorting};
        const Snapshot initial = initial_state(experiment, precision);
        const auto expected = reference_backend(precision, sorting.search)->make_tissue(experiment, initial);
        const auto found = place.backend(sorting).make_tissue(experiment, initial);
        expected->advance(before_reading);
        found->advance(before_reading);
        const SearchStatistics there = search_statistics(*expected).value(), here = search_statistics(*found).value();
        add(outcome.tally, numbers_of(there), numbers_of(here), sorting.text());
        most = std::max(most, there.neighbours_missed);
    }
    conclude(outcome);
    if (outcome.verdict == Verdict::passed && most == 0) return {Verdict::mistrusted, {}, "no neighbour is missed", {}};
    return outcome;
}

// Other concentrations and rates in the same places.
Snapshot turned_round(Snapshot state) {
    for (auto& plane : state.conc) std::ranges::reverse(plane);
    for (auto& plane : state.diff) std::ranges::reverse(plane);
    state.iteration = 2;
    return state;
}

// Nothing of what was there before may show: no lists, no means of rates, no rows of a larger lattice.
void write_over(Outcome& outcome, Place& place, const Experiment& experiment, const Setting& setting) {
    const Snapshot initial = initial_state(experiment, setting.precision), other = turned_round(initial);
    OpenclBackend& device = place.backend(setting);
    const auto reference = reference_backend(setting.precision, setting.search);
    Backend& truth = rounds_exactly(place, setting) ? static_cast<Backend&>(*reference) : device;
    const auto expected = truth.make_tissue(experiment, other), found = device.make_tissue(experiment, initial);
    found->advance(2 * before_reading);
    found->write(other);
    for (std::uint64_t i = 0; i < 2; ++i) {
        expected->advance(before_reading);
        found->advance(before_reading);
        add(outcome.tally, expected->read(), found->read(), setting.precision,
            fmt::format("{}{} iterations after the new state", setting.text(), (i + 1) * before_reading));
    }
}

const char* const mesh_to_write = R"(
define chemical A floor none
define chemical B
use chemical A conc 2 dev 1 diff 0.1 dev 0.05
use chemical B conc 2 dev 1 diff 0.2
create torus 13 8 weights cotangent
rule always react A by (0.1 * B - 0.1 * A) B by (0.01 * A)
)";

Outcome written_over(Place& place) {
    const Size flat = place.small() ? Size{19, 11} : Size{37, 26};
    Outcome outcome;
    for (const char* const name :
         {"rates/uneven/nine-point/no-flux", "rates/uneven/published/open", "growth/plain/absorbing"})
        write_over(outcome, place, lattice_case(name).experiment(flat), {.variants = 1});
    write_over(outcome, place, lattice_case("volume/rates/no-flux").experiment({7, 6, 5}), {.variants = 1});
    write_over(outcome, place, parse_experiment(mesh_to_write, "a mesh that is written", "."), {});
    const Experiment cells = parse_experiment(cell_cases().front().text(), "cells that are written", ".");
    for (const NeighbourSearch search : {NeighbourSearch::bins, NeighbourSearch::spatial_sorting})
        write_over(outcome, place, cells, {.search = search});
    conclude(outcome);
    return outcome;
}

}  // namespace

std::vector<Check> reading_checks() {
    return {{"writing/over-another-state", "single steps", true, written_over},
            {"reading/one-chemical", "single steps", true, one_chemical},
            {"reading/missed-neighbours", "neighbour search", true, missed_neighbours}};
}

}  // namespace pelage::verify
