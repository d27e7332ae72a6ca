// A rule's reaction: react NAME ... [scale PAR] MODEL PARAMETERS, as the table of reactions has them; or written out,
// react NAME by PAR [NAME by PAR ...]. What a network computes is in neural.cpp.
#include "language/statements.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace pelage::language {

namespace {

std::vector<std::string_view> model_words() {
    std::vector<std::string_view> words;
    for (const ModelFacts& facts : model_table()) words.push_back(facts.word);
    return words;
}

[[noreturn]] void unknown_partner(const Script& script, const Cursor& cursor) {
    std::vector<std::string_view> words = model_words();
    words.emplace_back("scale");
    words.emplace_back("by");
    words.emplace_back("neural");
    const Token& token = cursor.peek();
    for (const std::string_view name : script.chemical_names()) words.push_back(name);
    if (cursor.done()) cursor.unknown(token, words);
    cursor.fail(token, fmt::format("unknown chemical {}; {}{}", Cursor::shown(token), script.chemicals_defined(),
                                   token.quoted ? "" : suggestion(token.text, words)));
}

// The chemicals between `react` and `scale` or the model's word. Only from the third on does such a word win over a
// chemical of the same name: published files may name a chemical so.
std::vector<const Token*> parse_species(Script& script, Cursor& cursor, React& react) {
    const std::vector<std::string_view> words = model_words();
    const auto ends = [&](const Token& token) {
        return token.text == "scale" || std::ranges::find(words, token.text) != words.end();
    };
    std::vector<const Token*> names{&cursor.peek()};
    react.species.push_back(script.chemical(cursor));
    while (!cursor.done()) {
        const Token& next = cursor.peek();
        const bool chemical = !next.quoted && script.find_chemical(next.text).has_value();
        if (!chemical && names.size() == 1 && !ends(next)) unknown_partner(script, cursor);
        if (!chemical || (names.size() > 1 && ends(next))) break;
        names.push_back(&next);
        react.species.push_back(script.chemical(cursor));
    }
    return names;
}

std::string in_words(std::size_t count) {
    static constexpr std::array<std::string_view, 9> words{"no",   "one", "two",   "three", "four",
                                                           "five", "six", "seven", "eight"};
    return count < words.size() ? std::string(words[count]) : std::to_string(count);
}

void check_species(const Cursor& cursor, const React& react, const std::vector<const Token*>& names,
                   const Token& word) {
    const ModelFacts& model = react.model.facts();
    const std::size_t wanted = model.species.size();
    if (names.size() != wanted) {
        std::string places;
        for (std::size_t i = 0; i < wanted; ++i) places += "NAME ";
        cursor.fail(names.size() > wanted ? *names[wanted] : word,
                    fmt::format("'{}' takes {} chemical{}; write 'react {}{}'", model.word, in_words(wanted),
                                wanted == 1 ? "" : "s", places, model.word));
    }
    for (std::size_t i = 1; i < wanted; ++i) {
        const auto before = react.species.begin() + static_cast<std::ptrdiff_t>(i);
        if (std::find(react.species.begin(), before, react.species[i]) == before) continue;
        cursor.fail(*names[i], fmt::format("'{}' reacts with itself; give {} different chemicals", names[i]->text,
                                           in_words(wanted)));
    }
}

}  // namespace

namespace {

// NAME by EXPRESSION, once or more.
Action parse_formula(Script& script, Cursor& cursor) {
    Formula formula;
    do {
        const Token& name = cursor.peek();
        const std::size_t chemical = script.chemical(cursor);
        const auto same = [&](const Formula::Part& part) { return part.chemical == chemical; };
        if (std::ranges::any_of(formula.parts, same))
            cursor.fail(name, fmt::format("'{}' is given twice; its rate must be one expression", name.text));
        cursor.expect("by");
        formula.parts.push_back({chemical, parse_operand(script, cursor, "the rate of change")});
    } while (!cursor.done());
    return formula;
}

}  // namespace

Action parse_react(Script& script, Cursor& cursor) {
    if (is_neural(cursor)) return parse_neural(script, cursor);
    Cursor ahead = cursor;
    ahead.next();
    if (!ahead.done() && ahead.take("by")) return parse_formula(script, cursor);
    React react;
    const std::vector<const Token*> names = parse_species(script, cursor, react);
    if (cursor.take("scale")) react.scale = parse_operand(script, cursor, "the scale");
    const Token& word = cursor.peek();
    react.model = Model{cursor.choose(model_words())};
    check_species(cursor, react, names, word);
    for (const ModelParameter& parameter : react.model.facts().parameters) {
        cursor.expect(parameter.name);
        react.parameters.push_back(parse_operand(script, cursor, parameter.name));
    }
    return react;
}

}  // namespace pelage::language
