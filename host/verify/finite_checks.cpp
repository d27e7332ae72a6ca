// See check.hpp: the search for concentrations that are no longer numbers.
#include "core/prepattern.hpp"
#include "language/parse.hpp"
#include "verify/cases.hpp"
#include "verify/cases_cells.hpp"
#include "verify/check.hpp"
#include "verify/lab.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pelage::verify {

namespace {

const char* const mesh_to_search = R"(
define chemical A
define chemical B
use chemical A conc 2 dev 1 diff 0.1
use chemical B conc 2 dev 1
create torus 13 8
rule always change B conc 0.01
)";

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
constexpr auto with_all_bits = std::bit_cast<double>(0x7fffffffffffffffULL);  // another one

std::string place_in_words(const std::optional<NonFinite>& found) {
    return found ? fmt::format("chemical {}, cell {}", found->chemical, found->cell) : "none";
}

class Search {
public:
    Search(Outcome& outcome, const Experiment& experiment, const Snapshot& state, OpenclBackend& backend)
        : outcome_(outcome), state_(state), tissue_(backend.make_tissue(experiment, state)) {}

    void everywhere() {
        expect({}, "nothing");
        for (std::size_t chemical = 0; chemical < state_.conc.size(); ++chemical) {
            for (const std::size_t cell : {std::size_t{0}, std::size_t{1}, state_.cells() / 2, state_.cells() - 1}) {
                for (const double value : {no_number, with_all_bits, -infinite}) place(chemical, cell, value);
            }
        }
    }

    void in_last_cells() {
        for (std::size_t chemical = 0; chemical < state_.conc.size(); ++chemical) {
            place(chemical, state_.cells() - 1, no_number);
        }
    }

    // The first of two in a plane, wherever they lie: work-items may share cells in any way.
    void of_pairs() {
        constexpr std::size_t parts = 7;
        for (std::size_t one = 0; one < parts; ++one) {
            for (std::size_t other = one + 1; other <= parts; ++other) {
                const std::size_t low = one * state_.cells() / parts;
                const std::size_t high = other == parts ? state_.cells() - 1 : other * state_.cells() / parts;
                if (low >= high) continue;
                Snapshot hurt = state_;
                hurt.conc.back()[low] = hurt.conc.back()[high] = no_number;
                tissue_->write(hurt);
                expect(NonFinite{state_.conc.size() - 1, low}, fmt::format("cells {} and {}", low, high));
            }
        }
    }

    // The first in order of chemical and cell.
    void of_two() {
        Snapshot hurt = state_;
        hurt.conc.back().front() = infinite;
        hurt.conc.front().back() = no_number;
        hurt.conc.front()[state_.cells() / 2 + 1] = -infinite;
        tissue_->write(hurt);
        expect(NonFinite{0, state_.cells() / 2 + 1}, "three");
    }

private:
    void place(std::size_t chemical, std::size_t cell, double value) {
        Snapshot hurt = state_;
        hurt.conc[chemical][cell] = value;
        tissue_->write(hurt);
        expect(NonFinite{chemical, cell}, fmt::format("{}", value));
    }

    void expect(std::optional<NonFinite> wanted, const std::string& what) {
        const std::optional<NonFinite> found = tissue_->non_finite();
        outcome_.tally.cells_compared += state_.cells();
        const bool same = wanted.has_value() == found.has_value() &&
                          (!wanted || (wanted->chemical == found->chemical && wanted->cell == found->cell));
        if (same || outcome_.verdict == Verdict::failed) return;
        outcome_.verdict = Verdict::failed;
        outcome_.message = fmt::format("of values that are not finite ({}) the first is {}, found: {}", what,
                                       place_in_words(wanted), place_in_words(found));
    }

    Outcome& outcome_;
    Snapshot state_;
    std::unique_ptr<Tissue> tissue_;
};

Outcome search(Place& place, const Experiment& experiment) {
    Outcome outcome;
    for (const Precision precision : {Precision::single_, Precision::double_}) {
        if (precision == Precision::double_ && (place.small() || !place.device().fp64)) continue;
        // Groups that do not divide the cells, where there are two programs to compile anyway.
        const std::size_t group =
            precision == Precision::double_ ? std::min<std::size_t>(3, place.device().max_work_group) : 0;
        Search one(outcome, experiment, initial_state(experiment, precision),
                   place.backend({.precision = precision, .work_group = group}));
        place.small() ? one.in_last_cells() : one.everywhere();
        if (!place.small()) one.of_pairs();
        one.of_two();
    }
    return outcome;
}

}  // namespace

std::vector<Check> finite_checks() {
    return {{"values/not-finite", "not finite", true,
             [](Place& place) {
                 return search(place, lattice_case("reaction/fused").experiment({37, 26}));
             }},
            {"values/not-finite-far", "not finite", true,
             [](Place& place) {
                 if (place.small()) return Outcome{Verdict::skipped, {}, "left out with --small", {}};
                 Outcome outcome;
                 const Experiment wide = lattice_case("reaction/fused").experiment({65'559, 1});  // beyond 16 bits
                 const Snapshot state = initial_state(wide, Precision::single_);
                 Search(outcome, wide, state, place.backend({})).in_last_cells();
                 return outcome;
             }},
            {"volume/not-finite", "not finite", false,
             [](Place& place) {
                 return search(place, lattice_case("volume/diffusion/seven-point/wrap").experiment({7, 6, 5}));
             }},
            {"mesh/not-finite", "not finite", true,
             [](Place& place) { return search(place, parse_experiment(mesh_to_search, "a mesh", ".")); }},
            {"cells/not-finite", "not finite", true, [](Place& place) {
                 const CellCase& one = cell_cases().front();
                 return search(place, parse_experiment(one.text(), one.name, "."));
             }}};
}

}  // namespace pelage::verify
