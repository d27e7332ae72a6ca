// rule [from INT] [until INT] [every INT [offset INT]] CONDITION ACTION
#include "language/expression.hpp"
#include "language/statements.hpp"
#include "language/vocabulary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace pelage::language {

namespace {

struct Timing {
    std::uint64_t from = 0;
    std::uint64_t until = forever;
    std::uint64_t every = 1;
    std::uint64_t offset = 0;
};

Timing parse_timing(Cursor& cursor) {
    static constexpr std::array<std::string_view, 4> words{"from", "until", "every", "offset"};
    Timing timing;
    Options options(words);
    while (true) {
        const Token& token = cursor.peek();
        const auto option = options.next_if(cursor);
        if (!option) return timing;
        switch (*option) {
            case 0:
                timing.from = cursor.integer("the first iteration", 0, largest_iteration);
                break;
            case 1:
                timing.until = cursor.integer("the last iteration", 0, largest_iteration);
                break;
            case 2:
                timing.every = cursor.integer("the period", 1, largest_iteration);
                break;
            default:
                if (!options.given(2)) cursor.fail(token, "'offset' belongs to a period; write 'every INT' before it");
                timing.offset = cursor.integer("the offset", 0, largest_iteration);
        }
    }
}

constexpr std::array<std::string_view, 7> comparison_words{"==", "!=", "<", "<=", ">", ">=", "in"};
constexpr std::array<std::string_view, 3> condition_words{"always", "if", "probability"};

Condition parse_comparison(Script& script, Cursor& cursor) {
    static constexpr std::array comparisons{Comparison::equal,      Comparison::not_equal, Comparison::less,
                                            Comparison::less_equal, Comparison::greater,   Comparison::greater_equal};
    const bool expression = is_expression(cursor.peek());
    const Operand left = parse_operand(script, cursor, "the value compared");
    const bool compared =
        !cursor.done() && std::ranges::find(comparison_words, cursor.peek().text) != comparison_words.end();
    if (expression && !compared) return Compare{left, Comparison::not_equal, Operand::number(0.0)};
    const std::size_t which = cursor.choose(comparison_words);
    if (which < comparisons.size()) {
        return Compare{left, comparisons[which], parse_operand(script, cursor, "the value compared with")};
    }
    const Operand low = parse_operand(script, cursor, "the interval's low end");
    return Within{left, low, parse_operand(script, cursor, "the interval's high end")};
}

Condition parse_condition(Script& script, Cursor& cursor) {
    static constexpr std::array<std::string_view, 7> with_timing{"always", "if",    "probability", "from",
                                                                 "until",  "every", "offset"};
    const Token& word = cursor.peek();
    if (std::find(condition_words.begin(), condition_words.end(), word.text) == condition_words.end())
        cursor.unknown(word, with_timing);
    const std::size_t kind = cursor.choose(condition_words);
    if (kind == 0) return Always{};
    if (kind == 1) return parse_comparison(script, cursor);
    const Token& value = cursor.peek();
    const Operand chance = parse_operand(script, cursor, "the probability");
    if (chance.quantity == Quantity::number && (chance.value < 0.0 || chance.value > 1.0)) {
        cursor.fail(value,
                    fmt::format("'{}' is out of range; the probability must be a number from 0 to 1", value.text));
    }
    return Probability{chance};
}

}  // namespace

std::vector<std::string_view> words_of_conditions() { return {condition_words.begin(), condition_words.end()}; }
std::vector<std::string_view> words_of_comparisons() { return {comparison_words.begin(), comparison_words.end()}; }

void parse_rule(Script& script, Cursor& cursor) {
    const Timing timing = parse_timing(cursor);
    Rule rule;
    rule.line = cursor.line();
    rule.origin = script.phase_begin();
    rule.from = rule.origin + timing.from;
    rule.until = timing.until == forever ? forever : rule.origin + timing.until;
    if (script.in_phase()) rule.until = std::min(rule.until, script.phase_end() - 1);
    rule.every = timing.every;
    rule.offset = timing.offset;
    rule.condition = parse_condition(script, cursor);
    rule.action = parse_action(script, cursor, rule.condition);
    script.experiment.rules.push_back(std::move(rule));
}

}  // namespace pelage::language
