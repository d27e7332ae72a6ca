// Parameters of rules, and the names that stand for them.
#include "language/statements.hpp"
#include "language/vocabulary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

namespace pelage::language {

namespace {

struct QuantityWord {
    std::string_view text;
    Quantity quantity;
};

constexpr std::array<QuantityWord, 11> words{{{"NEIGHBORS", Quantity::neighbours},
                                              {"AGE", Quantity::age},
                                              {"BIRTH", Quantity::birth},
                                              {"X", Quantity::x},
                                              {"Y", Quantity::y},
                                              {"ROW", Quantity::row},
                                              {"COLUMN", Quantity::column},
                                              {"ROWS", Quantity::rows},
                                              {"COLUMNS", Quantity::columns},
                                              {"ITERATION", Quantity::iteration},
                                              {"RANDOM", Quantity::random}}};

const QuantityWord* find_word(std::string_view text) {
    const auto* const found =
        std::find_if(words.begin(), words.end(), [&](const QuantityWord& word) { return word.text == text; });
    return found == words.end() ? nullptr : found;
}

bool needs_lattice(Quantity quantity) {
    return quantity == Quantity::row || quantity == Quantity::column || quantity == Quantity::rows ||
           quantity == Quantity::columns;
}

[[noreturn]] void unknown_operand(const Script& script, const Cursor& cursor, std::string_view what) {
    const Token& token = cursor.peek();
    std::vector<std::string_view> allowed{"a number"};
    for (const Parameter& one : script.experiment.parameters) allowed.push_back(one.name);
    for (const QuantityWord& word : words) allowed.push_back(word.text);
    const std::string named = listed(script.chemical_names());
    const std::string chemicals = fmt::format("conc or diff of a chemical ({})", named);
    allowed.push_back(chemicals);
    for (const std::string& name : script.experiment.mappings) allowed.push_back(name);
    const std::string must = fmt::format("{} must be one of: {}", what, listed(allowed));
    if (cursor.done()) cursor.fail(token, fmt::format("the line ends too early; {}", must));
    for (const std::string_view name : script.chemical_names()) allowed.push_back(name);
    cursor.fail(token, fmt::format("unknown name {}; {}{}", Cursor::shown(token), must,
                                   token.quoted ? "" : suggestion(token.text, allowed)));
}

bool numeric(std::string_view text) {
    const auto first = static_cast<unsigned char>(text.empty() ? '\0' : text[0]);
    return std::isdigit(first) != 0 || first == '+' || first == '-' || first == '.' || to_number(text).has_value();
}

}  // namespace

std::vector<std::string_view> words_of_quantities() {
    std::vector<std::string_view> texts;
    for (const QuantityWord& word : words) texts.push_back(word.text);
    return texts;
}

Operand parse_operand(Script& script, Cursor& cursor, std::string_view what) {
    static constexpr std::array<std::string_view, 2> targets{"conc", "diff"};
    const Token& token = cursor.peek();
    if (cursor.done() || token.quoted) unknown_operand(script, cursor, what);
    if (const auto chemical = script.find_chemical(token.text)) {
        cursor.next();
        return cursor.choose(targets) == 0 ? Operand::concentration(*chemical) : Operand::rate(*chemical);
    }
    if (const QuantityWord* word = find_word(token.text)) {
        if (needs_lattice(word->quantity)) script.needs_lattice(cursor, token);
        cursor.next();
        return {word->quantity, 0.0, 0};
    }
    if (const auto mapping = script.find_mapping(token.text)) {
        cursor.next();
        return {Quantity::mapping, 0.0, *mapping};
    }
    if (!numeric(token.text) && cursor.parameter(token) == nullptr) unknown_operand(script, cursor, what);
    return Operand::number(cursor.number(what));
}

void check_name(const Cursor& cursor, const Token& name, std::string_view what) {
    const std::string_view text = name.text;
    const auto first = static_cast<unsigned char>(text[0]);
    const bool word = (std::isalpha(first) != 0 || first == '_') && std::all_of(text.begin(), text.end(), [](char c) {
                          return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-';
                      });
    std::string lower(text);
    for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    const bool number = lower == "inf" || lower == "infinity" || lower == "nan";
    if (!word || number || text.size() > 32) {
        cursor.fail(name,
                    fmt::format("'{}' cannot name a {}; names are a letter, then up to 31 letters, digits, _ or -{}",
                                shortened(text), what, number ? ", and no number" : ""));
    }
    if (find_word(text) != nullptr) {
        cursor.fail(name, fmt::format("'{}' cannot name a {}; it is a word of rules", text, what));
    }
}

}  // namespace pelage::language
