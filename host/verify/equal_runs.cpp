// See equal_runs.hpp.
#include "verify/equal_runs.hpp"

#include "core/columns.hpp"
#include "core/error.hpp"
#include "core/prepattern.hpp"
#include "verify/compare.hpp"
#include "verify/dice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace pelage::verify {

namespace {

template <class Column>
void drop(Column&, Column&) {}  // whole numbers know no NaN

void drop(std::vector<double>& a, std::vector<double>& b) {
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
        if (std::isnan(a[i]) && std::isnan(b[i])) a[i] = b[i] = 0.0;
    }
}

void drop(ColumnList& a, ColumnList& b) {
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) drop(a[i], b[i]);
}

std::string place_of(const std::optional<NonFinite>& found) {
    return found ? fmt::format("cell {} of chemical {}", found->cell, found->chemical) : "none";
}

std::string compared(const Tissue& expected, const Tissue& found) {
    Snapshot a = expected.read();
    Snapshot b = found.read();
    drop_shared_nans(a, b);
    std::string text;
    for (const std::string& line : differences(a, b)) text += line + "\n";
    const std::string first_a = place_of(expected.non_finite());
    const std::string first_b = place_of(found.non_finite());
    if (first_a != first_b) text += fmt::format("first value not finite: {} expected, {} found\n", first_a, first_b);
    return text;
}

// Mostly short ones: a stretch may be shorter than what a backend carries out in one go.
std::uint64_t stretch(Dice& dice, std::uint64_t left) {
    const std::uint64_t most = dice.pick<std::uint64_t>({1, 2, 5, 16, 1000});
    return dice.from_to(1, static_cast<std::size_t>(std::min(most, left)));
}

}  // namespace

void drop_shared_nans(Snapshot& a, Snapshot& b) {
    each_column([](const char*, auto& mine, auto& theirs) { drop(mine, theirs); }, a, b);
}

EqualRun run_both(const Experiment& experiment, Backend& expected, Backend& found, std::uint64_t seed) {
    EqualRun result;
    std::uint64_t reached = 0;
    try {
        Dice dice(seed);
        const Snapshot initial = initial_state(experiment, expected.precision());
        const std::uint64_t end = experiment.last_iteration();
        const std::unique_ptr<Tissue> a = expected.make_tissue(experiment, initial);
        std::unique_ptr<Tissue> b = found.make_tissue(experiment, initial);
        const std::uint64_t resumed = end == 0 ? 0 : dice.below(static_cast<std::size_t>(end));
        bool anew = false;
        while (reached < end && result.difference.empty()) {
            if (!anew && reached >= resumed) {
                b = found.make_tissue(experiment, b->read());
                anew = true;
            }
            const std::uint64_t steps = stretch(dice, end - reached);
            a->advance(steps);
            b->advance(steps);
            reached += steps;
            result.difference = compared(*a, *b);
            if (dice.chance(15)) b->write(b->read());
        }
        result.finite = !a->non_finite().has_value();
        result.cells = a->cells();
    } catch (const Error& error) {
        result.difference = fmt::format("an error: {}\n", error.what());
    }
    if (!result.difference.empty())
        result.difference = fmt::format("after iteration {}: {}", reached, result.difference);
    return result;
}

}  // namespace pelage::verify
