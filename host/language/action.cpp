// What a rule does: react, change, set, map, polarize, divide, move, expand, aggregate, and
#include "language/parse.hpp"
#include "language/statements.hpp"
#include "language/vocabulary.hpp"

#include <fmt/format.h>

#include <array>
#include <string_view>

namespace pelage::language {

namespace {

struct Goal {
    std::size_t chemical = 0;
    Target target = Target::concentration;
};

Goal parse_goal(const Script& script, Cursor& cursor) {
    static constexpr std::array<std::string_view, 2> words{"conc", "diff"};
    const std::size_t chemical = script.chemical(cursor);
    return {chemical, cursor.choose(words) == 0 ? Target::concentration : Target::rate};
}

Action parse_change(Script& script, Cursor& cursor) {
    const Goal goal = parse_goal(script, cursor);
    const Operand amount = parse_operand(script, cursor, "the amount");
    return Change{goal.target, goal.chemical, amount, parse_deviation(cursor)};
}

Action parse_replace(Script& script, Cursor& cursor) {
    const Goal goal = parse_goal(script, cursor);
    return Set{goal.target, goal.chemical, parse_operand(script, cursor, "the value")};
}

std::size_t parse_mapping(Script& script, Cursor& cursor) {
    const Token& name = cursor.value("the mapping's name");
    if (const auto known = script.find_mapping(name.text)) return *known;
    check_name(script, cursor, name, "mapping");
    auto& mappings = script.experiment.mappings;
    if (mappings.size() == largest_mapping_count) {
        cursor.fail(name, fmt::format("one mapping too many; at most {} are allowed", largest_mapping_count));
    }
    mappings.emplace_back(name.text);
    return mappings.size() - 1;
}

Action parse_map(Script& script, Cursor& cursor) {
    Map map;
    map.value = parse_operand(script, cursor, "the mapped value");
    map.from_low = cursor.number("the interval's low end");
    const Token& high = cursor.peek();
    map.from_high = cursor.number("the interval's high end");
    if (static_cast<float>(map.from_low) == static_cast<float>(map.from_high))
        cursor.fail(high, "the interval is empty; 'map' needs two different ends");
    cursor.expect("to");
    map.mapping = parse_mapping(script, cursor);
    map.to_low = cursor.number("the mapping's low value");
    map.to_high = cursor.number("the mapping's high value");
    return map;
}

// ---- cells that move

Action parse_polarize(Script& script, Cursor& cursor) {
    const Polarize polarize{script.chemical(cursor)};
    cursor.expect("conc");
    return polarize;
}

Action parse_divide(Script& script, Cursor& cursor) {
    Divide divide;
    if (cursor.done()) return divide;
    cursor.expect("direction");
    divide.direction = parse_operand(script, cursor, "the direction");
    divide.deviation = parse_deviation(cursor);
    return divide;
}

Action parse_move(Script& script, Cursor& cursor) {
    const Operand distance = parse_operand(script, cursor, "the distance");
    return Move{distance, parse_deviation(cursor)};
}

// ---- growth of a matrix

void parse_weight(Cursor& cursor, Expand& expand) {
    static constexpr std::array<std::string_view, 2> words{"rows", "columns"};
    expand.band_weight = cursor.number("the weight", positive);
    expand.band_rows = cursor.choose(words) == 0;
    expand.band_low = cursor.number("the band's low end", fraction);
    cursor.expect("to");
    const Token& high = cursor.peek();
    expand.band_high = cursor.number("the band's high end", fraction);
    if (expand.band_high < expand.band_low) cursor.fail(high, "the band's high end is below its low end");
}

void check_expand(Cursor& cursor, const Expand& expand, const Options& given, const Token& at, const Token& weight) {
    if (expand.columns + expand.rows == 0)
        cursor.fail(at, "'expand' inserts nothing; give 'columns INT' or 'rows INT'");
    if (expand.interpolation && (given.given(2) || given.given(3) || given.given(4)))
        cursor.fail(at, "'by' stretches the matrix and draws nothing; leave out 'first', 'distribution' and 'weight'");
    if (!given.given(4)) return;
    if (expand.distribution == Distribution::shuffled) {
        cursor.fail(weight, "'shuffled' picks every place equally often; 'weight' needs another distribution");
    }
    if (expand.band_rows ? expand.rows == 0 : expand.columns == 0) {
        cursor.fail(weight, fmt::format("'weight ... {0}' weighs the insertion of {0}; give '{0} INT'",
                                        expand.band_rows ? "rows" : "columns"));
    }
}

constexpr std::array<std::string_view, 6> expand_words{"columns", "rows", "first", "distribution", "weight", "by"};

Distribution parse_distribution(Cursor& cursor) {
    static constexpr std::array<std::string_view, 4> names{"uniform", "shuffled", "normal", "triangular"};
    static constexpr std::array distributions{Distribution::uniform, Distribution::shuffled, Distribution::normal,
                                              Distribution::triangular};
    return distributions[cursor.choose(names)];
}

Interpolation parse_interpolation(Cursor& cursor) {
    static constexpr std::array<std::string_view, 3> names{"nearest", "bilinear", "bicubic"};
    static constexpr std::array interpolations{Interpolation::nearest, Interpolation::bilinear, Interpolation::bicubic};
    return interpolations[cursor.choose(names)];
}

// What comes after that one of expand_words.
void parse_expand_option(Cursor& cursor, std::size_t option, Expand& expand) {
    static constexpr std::array<std::string_view, 2> order{"columns", "rows"};
    constexpr std::uint64_t most = 1000;  // at a time, as validate() has it
    if (option == 0) expand.columns = cursor.integer("the number of columns", 0, most);
    if (option == 1) expand.rows = cursor.integer("the number of rows", 0, most);
    if (option == 2) expand.rows_first = cursor.choose(order) == 1;
    if (option == 3) expand.distribution = parse_distribution(cursor);
    if (option == 4) parse_weight(cursor, expand);
    if (option == 5) expand.interpolation = parse_interpolation(cursor);
}

Action parse_expand(Script&, Cursor& cursor, const Token& at) {
    Expand expand;
    Options options(expand_words);
    const Token* weight = &at;
    while (true) {
        const Token& token = cursor.peek();
        const auto option = options.next(cursor);
        if (!option) break;
        if (expand_words[*option] == "weight") weight = &token;
        parse_expand_option(cursor, *option, expand);
    }
    check_expand(cursor, expand, options, at, *weight);
    return expand;
}

// ---- the table of actions

template <Action (*parse)(Script&, Cursor&)>
Action without_word(Script& script, Cursor& cursor, const Token&) {
    return parse(script, cursor);
}

Action parse_and(Script&, Cursor&, const Token&) { return And{}; }

struct ActionWord {
    std::string_view word;
    Action (*parse)(Script&, Cursor&, const Token& word);
    bool always_only = false;                                           // takes no other condition
    void (Script::*wants)(const Cursor&, const Token& word) = nullptr;  // of the tissue, checked at the end of the file
};

constexpr std::array<ActionWord, 10> actions{{{"react", without_word<parse_react>},
                                              {"change", without_word<parse_change>},
                                              {"set", without_word<parse_replace>},
                                              {"map", without_word<parse_map>, true},
                                              {"polarize", without_word<parse_polarize>, false, &Script::needs_plane},
                                              {"divide", without_word<parse_divide>, false, &Script::refuses_matrix},
                                              {"move", without_word<parse_move>, false, &Script::refuses_matrix},
                                              {"expand", parse_expand, true, &Script::expands},
                                              {"aggregate", without_word<parse_aggregate>, true, &Script::needs_plane},
                                              {"and", parse_and}}};

constexpr auto action_words = [] {
    std::array<std::string_view, actions.size()> words;
    for (std::size_t i = 0; i < words.size(); ++i) words[i] = actions[i].word;
    return words;
}();

}  // namespace

std::vector<std::string_view> words_of_actions() { return {action_words.begin(), action_words.end()}; }

Action parse_action(Script& script, Cursor& cursor, const Condition& condition) {
    const Token& word = cursor.peek();
    const ActionWord& action = actions[cursor.choose(action_words)];
    if (action.always_only && !std::holds_alternative<Always>(condition)) {
        cursor.fail(word, fmt::format("'{}' takes the condition 'always' and no other", word.text));
    }
    if (action.wants != nullptr) (script.*action.wants)(cursor, word);
    return action.parse(script, cursor, word);
}

}  // namespace pelage::language
