// aggregate ORDER POTENTIAL [eta PAR] [radius PAR] [towards X Y strength PAR]: charges that gather.
#include "language/statements.hpp"

#include <array>

namespace pelage::language {

Action parse_aggregate(Script& script, Cursor& cursor) {
    static constexpr std::array<std::string_view, 3> words{"eta", "radius", "towards"};
    Aggregate aggregate;
    aggregate.order = script.chemical(cursor);
    const Token& second = cursor.peek();
    aggregate.potential = script.chemical(cursor);
    if (aggregate.potential == aggregate.order)
        cursor.fail(second, "the order of arrival and the potential need two different chemicals");
    Options options(words);
    while (const auto option = options.next(cursor)) {
        if (*option == 0) aggregate.eta = parse_operand(script, cursor, "eta");
        if (*option == 1) aggregate.radius = parse_operand(script, cursor, "the radius");
        if (*option != 2) continue;
        aggregate.x = parse_operand(script, cursor, "the place's x");
        aggregate.y = parse_operand(script, cursor, "the place's y");
        cursor.expect("strength");
        aggregate.strength = parse_operand(script, cursor, "the strength");
    }
    return aggregate;
}

}  // namespace pelage::language
