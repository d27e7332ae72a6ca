// aggregate ORDER POTENTIAL [eta PAR] [radius PAR] [towards X Y strength PAR] [seed SEED] [size SIZE PAR]
// [far-field]: charges that gather.
#include "language/statements.hpp"
#include "language/vocabulary.hpp"

#include <fmt/format.h>

#include <array>
#include <optional>

namespace pelage::language {

namespace {

// A chemical that holds something of charges, and nothing else of them.
std::size_t parse_held(Script& script, Cursor& cursor, const Aggregate& aggregate) {
    const Token& name = cursor.peek();
    const std::size_t chemical = script.chemical(cursor);
    for (const std::optional<std::size_t> other :
         {std::optional(aggregate.order), std::optional(aggregate.potential), aggregate.seed, aggregate.size}) {
        if (other != chemical) continue;
        cursor.fail(name,
                    fmt::format("'{}' holds something else of charges already; take another chemical", name.text));
    }
    return chemical;
}

void parse_towards(Script& script, Cursor& cursor, Aggregate& aggregate) {
    aggregate.x = parse_operand(script, cursor, "the place's x");
    aggregate.y = parse_operand(script, cursor, "the place's y");
    cursor.expect("strength");
    aggregate.strength = parse_operand(script, cursor, "the strength");
}

constexpr std::array<std::string_view, 6> aggregate_words{"eta", "radius", "towards", "seed", "size", "far-field"};

}  // namespace

std::vector<std::string_view> words_of_aggregates() { return {aggregate_words.begin(), aggregate_words.end()}; }

Action parse_aggregate(Script& script, Cursor& cursor) {
    Aggregate aggregate;
    aggregate.order = script.chemical(cursor);
    const Token& second = cursor.peek();
    aggregate.potential = script.chemical(cursor);
    if (aggregate.potential == aggregate.order)
        cursor.fail(second, "the order of arrival and the potential need two different chemicals");
    Options options(aggregate_words);
    const Token* towards = nullptr;
    while (true) {
        const Token& word = cursor.peek();
        const auto option = options.next(cursor);
        if (!option) break;
        if (*option == 2) towards = &word;
        if (*option == 5) aggregate.far_field = true;
        if (*option == 0) aggregate.eta = parse_operand(script, cursor, "eta");
        if (*option == 1) aggregate.radius = parse_operand(script, cursor, "the radius");
        if (*option == 2) parse_towards(script, cursor, aggregate);
        if (*option == 3) aggregate.seed = parse_held(script, cursor, aggregate);
        if (*option != 4) continue;
        aggregate.size = parse_held(script, cursor, aggregate);
        aggregate.grown = parse_operand(script, cursor, "the size of a new charge");
    }
    if (towards != nullptr && aggregate.far_field) {
        cursor.fail(*towards,
                    "'towards' and 'far-field' exclude each other: where a place draws the growth, every "
                    "candidate is looked at; leave out one of them");
    }
    return aggregate;
}

}  // namespace pelage::language
