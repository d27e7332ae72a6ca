// previous(U): a chemical that no line defines keeps what U was an iteration ago. It starts as U does, and a rule
// behind all others sets it.
#include "language/script.hpp"

#include <fmt/format.h>

#include <utility>

namespace pelage::language {

std::size_t Script::previous_of(std::size_t chemical, const Cursor& cursor, const Token& at) {
    for (const Kept& kept : kept_) {
        if (kept.chemical == chemical) return kept.keeper;
    }
    if (experiment.chemicals.size() == largest_chemical_count) {
        cursor.fail(at,
                    fmt::format("'previous' needs a chemical more; at most {} are allowed", largest_chemical_count));
    }
    Chemical keeper;
    keeper.name = fmt::format("previous({})", experiment.chemicals[chemical].name);
    keeper.bounds = {-infinity, infinity};
    const auto add = [&](Phase& phase) {
        phase.bounds.push_back(keeper.bounds);
        if (phase.rates.size() == experiment.chemicals.size()) phase.rates.emplace_back();
    };
    add(before_);
    for (Phase& phase : experiment.phases) add(phase);
    experiment.chemicals.push_back(std::move(keeper));
    kept_.push_back({chemical, experiment.chemicals.size() - 1, cursor.place(at)});
    return kept_.back().keeper;
}

void Script::finish_previous() {
    for (const Kept& kept : kept_) {
        const Operand now = Operand::concentration(kept.chemical);
        const auto keep = [&](const Operand& operand) {
            experiment.expressions.push_back(
                {keeper_name(kept), {{Operation::operand, operand, {}, 0, {}}}, kept.place.line});
            return experiment.expressions.size() - 1;
        };
        SetCells start;
        start.where = keep(Operand::number(1.0));
        start.what = SetConcentration{kept.keeper, {0.0, 0.0, keep(now)}};
        this->start(start, kept.place);
        experiment.chemicals[kept.keeper].initial = experiment.chemicals[kept.chemical].initial;
        Rule rule;
        rule.line = kept.place.line;
        rule.action = Set{Target::concentration, kept.keeper, now};
        experiment.rules.push_back(std::move(rule));
    }
}

const std::string& Script::keeper_name(const Kept& kept) const { return experiment.chemicals[kept.keeper].name; }

}  // namespace pelage::language
