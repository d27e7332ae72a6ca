// See rates.hpp.
#include "core/rates.hpp"

#include <algorithm>
#include <variant>

namespace pelage {

namespace {

bool changes_rate(const Rule& rule, std::size_t chemical) {
    const auto hits = [&](const auto* action) {
        return action != nullptr && action->target == Target::rate && action->chemical == chemical;
    };
    return hits(std::get_if<Change>(&rule.action)) || hits(std::get_if<Set>(&rule.action));
}

}  // namespace

RateKind rate_kind(const Experiment& experiment, const std::vector<double>& rates, std::size_t chemical) {
    const auto changes = [&](const Rule& rule) { return changes_rate(rule, chemical); };
    if (std::ranges::any_of(experiment.rules, changes)) return RateKind::per_cell;
    const double first = rates.empty() ? 0.0 : rates.front();
    if (std::ranges::any_of(rates, [&](double rate) { return rate != first; })) return RateKind::per_cell;
    const auto sets = [&](const Phase& phase) { return phase.rates[chemical].has_value(); };
    return first == 0.0 && std::ranges::none_of(experiment.phases, sets) ? RateKind::none : RateKind::uniform;
}

}  // namespace pelage
