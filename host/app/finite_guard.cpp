// See finite_guard.hpp.
#include "app/finite_guard.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace pelage::app {

FiniteGuard::FiniteGuard(Tissue& tissue) : tissue_(tissue), finite_after_(tissue.iteration()) {}

std::optional<Breakdown> FiniteGuard::look() {
    const std::optional<NonFinite> found = tissue_.non_finite();
    if (!found) {
        finite_after_ = tissue_.iteration();
        if (due()) keep();
        return std::nullopt;
    }
    Breakdown breakdown{*found, finite_after_, tissue_.iteration()};
    if (kept_) narrow(breakdown);
    return breakdown;
}

void FiniteGuard::keep() {
    const auto start = Clock::now();
    kept_ = tissue_.read();
    kept_at_ = Clock::now();
    cost_ = kept_at_ - start;
}

// Rare enough to cost at most a fiftieth of the run, often enough to come back within seconds.
bool FiniteGuard::due() const {
    if (tissue_.cells() > largest_kept) return false;
    if (!kept_) return true;
    return Clock::now() - kept_at_ > std::max<Clock::duration>(std::chrono::seconds(3), 50 * cost_);
}

// Halves the stretch between a finite and a non-finite state until they are one iteration apart.
void FiniteGuard::narrow(Breakdown& breakdown) {
    tissue_.write(*kept_);
    tissue_.advance(breakdown.finite_after - kept_->iteration);
    keep();
    while (breakdown.iteration - breakdown.finite_after > 1) {
        const std::uint64_t middle = breakdown.finite_after + (breakdown.iteration - breakdown.finite_after) / 2;
        tissue_.write(*kept_);
        tissue_.advance(middle - breakdown.finite_after);
        if (const auto found = tissue_.non_finite()) {
            breakdown.iteration = middle;
            breakdown.where = *found;
        } else {
            breakdown.finite_after = middle;
            keep();
        }
    }
    tissue_.write(*kept_);
    tissue_.advance(breakdown.iteration - breakdown.finite_after);
}

std::string describe(const Breakdown& breakdown, const Tissue& tissue) {
    const Snapshot state = tissue.read();
    const auto [chemical, cell] = breakdown.where;
    std::string place = fmt::format("cell {}", cell);
    if (state.on_grid()) {
        const std::size_t line = cell / state.columns;
        const std::string layer = state.volume() ? fmt::format("layer {}, ", line / state.rows) : "";
        place += fmt::format(" ({}row {}, column {})", layer, line % state.rows, cell % state.columns);
    }
    const bool exact = breakdown.iteration <= breakdown.finite_after + 1;
    const std::string when =
        exact ? fmt::format("in iteration {}", breakdown.iteration)
              : fmt::format("between iterations {} and {}", breakdown.finite_after, breakdown.iteration);
    return fmt::format("chemical '{}' became {} {}, first in {}", tissue.experiment().chemicals[chemical].name,
                       state.conc[chemical][cell], when, place);
}

}  // namespace pelage::app
