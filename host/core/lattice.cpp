// See lattice.hpp.
#include "core/lattice.hpp"

#include "core/error.hpp"

#include <algorithm>
#include <variant>

namespace pelage {

namespace {

// Judged from the statements, not from a state: a phase may later make unequal rates equal, and a run resumed from
// there must take the same formula.
bool prepattern_varies_rate(const Experiment& experiment, std::size_t chemical) {
    std::size_t uses = 0;
    for (const Statement& statement : experiment.prepattern) {
        if (const auto* use = std::get_if<UseChemical>(&statement)) {
            if (use->chemical != chemical || !use->diff) continue;
            if (use->diff->expression || use->diff->deviation != 0.0 || ++uses > 1) return true;
        } else if (const auto* set = std::get_if<SetCells>(&statement)) {
            const auto* rate = std::get_if<SetRate>(&set->what);
            if (rate != nullptr && rate->chemical == chemical) return true;
        }
    }
    return false;
}

RateKind lattice_rate(const Experiment& experiment, const Snapshot& initial, std::size_t chemical) {
    if (experiment.chemicals[chemical].anisotropic || prepattern_varies_rate(experiment, chemical))
        return RateKind::per_cell;
    const RateKind kind = rate_kind(experiment, initial.diff[chemical], chemical);
    // Sums of rows are for stencils with two weights: one's own goes from neighbour to neighbour.
    return kind == RateKind::uniform && experiment.stencil == Stencil::own ? RateKind::per_cell : kind;
}

bool uses_polarity(const Experiment& experiment, const Snapshot& initial) {
    const auto polarizes = [](const Rule& rule) { return std::holds_alternative<Polarize>(rule.action); };
    if (std::any_of(experiment.rules.begin(), experiment.rules.end(), polarizes)) return true;
    const auto set = [](double p) { return p != 0.0; };
    const bool any = std::any_of(initial.polarity_x.begin(), initial.polarity_x.end(), set) ||
                     std::any_of(initial.polarity_y.begin(), initial.polarity_y.end(), set);
    return any && std::any_of(experiment.chemicals.begin(), experiment.chemicals.end(),
                              [](const Chemical& chemical) { return chemical.anisotropic; });
}

}  // namespace

LatticePlan lattice_plan(const Experiment& experiment, const Snapshot& initial) {
    const Space space = space_of(experiment);
    LatticePlan plan;
    if (const auto* lattice = std::get_if<Lattice>(&space)) {
        static_cast<Lattice&>(plan) = *lattice;
    } else if (const auto* volume = std::get_if<Volume>(&space)) {
        plan.boundary = volume->boundary;
        plan.stencil = volume->stencil;
        plan.layers = initial.layers;
    } else {
        throw Error(experiment.source + ": the tissue is not a lattice");
    }
    plan.columns = initial.columns;  // it may have grown
    plan.rows = initial.rows;
    for (std::size_t chemical = 0; chemical < experiment.chemicals.size(); ++chemical) {
        plan.rates.push_back(lattice_rate(experiment, initial, chemical));
    }
    plan.polarity = uses_polarity(experiment, initial);
    return plan;
}

}  // namespace pelage
