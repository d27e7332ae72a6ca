// use chemical | polarity | seed, and values with a deviation.
#include "language/expression.hpp"
#include "language/statements.hpp"

#include <fmt/format.h>

#include <array>

namespace pelage::language {

double parse_deviation(Cursor& cursor) {
    return cursor.take("dev") ? cursor.number("the deviation", not_negative) : 0.0;
}

Spread parse_spread(Cursor& cursor, std::string_view what) {
    const double value = cursor.number(what);
    return {value, parse_deviation(cursor)};
}

Spread parse_start_value(Script& script, Cursor& cursor, std::string_view what) {
    const Token& token = cursor.peek();
    if (cursor.done() || !is_expression(token)) return parse_spread(cursor, what);
    Expression expression = parse_expression(script, cursor, Scope::start, what);
    const Operand& first = expression.nodes.front().operand;
    if (expression.nodes.size() == 1 && first.quantity == Quantity::number)
        return {first.value, parse_deviation(cursor)};
    if (!cursor.done() && cursor.peek().text == "dev")
        cursor.fail(cursor.peek(), "an expression takes no 'dev'; draw within it, with RANDOM");
    return {0.0, 0.0, keep_expression(script, cursor, token, std::move(expression))};
}

std::optional<Spread> parse_degrees(Cursor& cursor) {
    if (cursor.take("none")) return std::nullopt;
    return parse_spread(cursor, "the polarity in degrees ('none' for no polarity)");
}

namespace {

std::size_t used_chemical(const Script& script, Cursor& cursor) {
    const Token& name = cursor.peek();
    if (!cursor.done() && (name.quoted || !script.find_chemical(name.text))) {
        cursor.fail(name, fmt::format("unknown chemical {}: 'use' names a chemical that is not defined; {}{}",
                                      Cursor::shown(name), script.chemicals_defined(),
                                      suggestion(name.text, script.chemical_names())));
    }
    return script.chemical(cursor);
}

// Inside a phase: every cell's diffusion rate from its first iteration on.
void parse_phase_rate(Script& script, Cursor& cursor) {
    const std::size_t chemical = used_chemical(script, cursor);
    cursor.expect("diff");
    script.phase().rates[chemical] = cursor.number("the diffusion rate", not_negative);
}

void use_chemical(Script& script, Cursor& cursor) {
    static constexpr std::array<std::string_view, 2> words{"conc", "diff"};
    if (script.in_phase()) return parse_phase_rate(script, cursor);
    const Token& name = cursor.peek();
    const std::size_t chemical = used_chemical(script, cursor);
    UseChemical use;
    use.chemical = chemical;
    Options options(words);
    const Token* conc = &name;
    const Token* diff = &name;
    while (const auto option = options.next(cursor)) {
        (*option == 0 ? conc : diff) = &cursor.peek();
        if (*option == 0)
            use.conc = parse_start_value(script, cursor, "the concentration");
        else
            use.diff = parse_start_value(script, cursor, "the diffusion rate");
    }
    script.start(use, {cursor.place(*conc), cursor.place(*diff)});
}

}  // namespace

void parse_use(Script& script, Cursor& cursor) {
    static constexpr std::array<std::string_view, 3> words{"chemical", "polarity", "seed"};
    const Token& word = cursor.peek();
    const std::size_t what = cursor.choose(words);
    if (what == 0) return use_chemical(script, cursor);
    script.outside_phases(cursor, word, fmt::format("use {}", word.text));
    if (what == 2) return script.start(UseSeed{cursor.signed_integer("the seed")}, cursor.place(word));
    script.needs_plane(cursor, word);
    script.start(UsePolarity{parse_degrees(cursor)}, cursor.place(word));
}

}  // namespace pelage::language
