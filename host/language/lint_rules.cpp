// Lints of rules: those that never act, for their time or for their condition.
#include "core/schedule.hpp"
#include "language/lints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace pelage::language {

namespace {

// The rule as the reader knows it, with what becomes of it.
std::string never(const Rule& rule, const char* verb) {
    const bool joins = std::holds_alternative<And>(rule.action);
    return fmt::format("this rule never {}{}", verb, joins ? ", nor does the one that its 'and' joins" : "");
}

// The first iteration at which the rule may act. Iterations are told as counted from the start of the run.
std::uint64_t beginning(const Rule& rule) { return std::max(rule.from, rule.origin + rule.offset); }

std::string why_never(const Sheet& sheet, const Rule& rule) {
    const std::uint64_t first = next_active(rule, 0);
    if (first != forever) return fmt::format("it would begin at {}, and the run ends at {}", first, sheet.last);
    if (beginning(rule) > rule.until) {
        return fmt::format("it would begin at {}, after its last iteration {}", beginning(rule), rule.until);
    }
    return fmt::format("no iteration of its period lies between {} and {}", rule.from, rule.until);
}

bool phase_began(const Sheet& sheet, const Rule& rule) { return rule.origin == 0 || rule.origin < sheet.last; }

// Iterations at which a rule may act: from the first to the last, both included; empty: none.
struct Span {
    std::uint64_t first = 0;
    std::uint64_t last = 0;
};

std::optional<Span> span(const Sheet& sheet, const Rule& rule) {
    const std::uint64_t first = next_active(rule, 0);
    if (first >= sheet.last) return std::nullopt;
    return Span{first, std::min(rule.until, sheet.last - 1)};
}

}  // namespace

void find_idle_rules(const Sheet& sheet, Reporter& report) {
    for (const Rule& rule : sheet.experiment.rules) {
        if (sheet.last == 0 || !phase_began(sheet, rule) || span(sheet, rule)) continue;
        report(sheet.place(rule.line), fmt::format("{}: {}", never(rule, "acts"), why_never(sheet, rule)));
    }
}

void find_impossible_conditions(const Sheet& sheet, Reporter& report) {
    for (const Rule& rule : sheet.experiment.rules) {
        const std::optional<Span> when = span(sheet, rule);
        if (!when) continue;
        const std::string why = why_impossible(sheet.experiment, rule.condition, when->first, when->last);
        if (why.empty()) continue;
        const bool chance = std::holds_alternative<Probability>(rule.condition);
        report(sheet.place(rule.line, chance ? "probability" : "if"), fmt::format("{}: {}", never(rule, "acts"), why));
    }
}

void find_dangling_and(const Sheet& sheet, Reporter& report) {
    if (sheet.experiment.rules.empty()) return;
    const Rule& final = sheet.experiment.rules.back();
    if (!std::holds_alternative<And>(final.action)) return;
    report(sheet.place(final.line, "and"), "no rule follows that this condition could join");
}

}  // namespace pelage::language
