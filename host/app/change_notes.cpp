// See change_notes.hpp.
#include "app/change_notes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <variant>

namespace pelage::app {

namespace {

// Those of the phases in which the rule may act, in order, each once.
std::vector<double> time_steps(const Experiment& experiment, const Rule& rule) {
    std::vector<double> steps;
    for (std::size_t i = 0; i < experiment.phases.size(); ++i) {
        const Phase& phase = experiment.phases[i];
        const std::uint64_t end = i + 1 < experiment.phases.size() ? experiment.phases[i + 1].begin : forever;
        if (phase.begin > rule.until || end <= std::max(rule.from, rule.origin)) continue;
        if (std::find(steps.begin(), steps.end(), phase.time_step) == steps.end()) steps.push_back(phase.time_step);
    }
    return steps;
}

std::string note(const Experiment& experiment, const Rule& rule, const Change& change) {
    const auto steps = time_steps(experiment, rule);
    if (std::all_of(steps.begin(), steps.end(), [](double step) { return step == 1.0; })) return {};
    const std::string occasion = rule.every == 1 ? "every iteration" : fmt::format("every {} iterations", rule.every);
    const bool number = change.amount.quantity == Quantity::number;
    std::vector<std::string> rates;
    for (const double step : steps) {
        const double scale = 1.0 / (step * static_cast<double>(rule.every));
        rates.push_back(fmt::format("{:.6g}{} a unit of time at time_step {}",
                                    number ? change.amount.value * scale : scale, number ? "" : " times that", step));
    }
    return fmt::format("line {}: `change {}` has no time step in it: it adds {} in {}, which is {}", rule.line,
                       experiment.chemicals[change.chemical].name,
                       number ? fmt::format("{}", change.amount.value) : "its value", occasion, fmt::join(rates, ", "));
}

}  // namespace

std::vector<std::string> change_notes(const Experiment& experiment) {
    std::vector<std::string> notes;
    for (const Rule& rule : experiment.rules) {
        const auto* change = std::get_if<Change>(&rule.action);
        if (change == nullptr || change->target != Target::concentration) continue;
        if (auto text = note(experiment, rule, *change); !text.empty()) notes.push_back(std::move(text));
    }
    return notes;
}

}  // namespace pelage::app
