// Parameters of rules, and the names that stand for them.
#include "core/functions.hpp"
#include "core/scene.hpp"
#include "language/expression.hpp"
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

constexpr std::array<QuantityWord, 15> words{{{"NEIGHBORS", Quantity::neighbours},
                                              {"AGE", Quantity::age},
                                              {"BIRTH", Quantity::birth},
                                              {"X", Quantity::x},
                                              {"Y", Quantity::y},
                                              {"Z", Quantity::z},
                                              {"ROW", Quantity::row},
                                              {"COLUMN", Quantity::column},
                                              {"LAYER", Quantity::layer},
                                              {"ROWS", Quantity::rows},
                                              {"COLUMNS", Quantity::columns},
                                              {"LAYERS", Quantity::layers},
                                              {"ITERATION", Quantity::iteration},
                                              {"TIME", Quantity::time},
                                              {"RANDOM", Quantity::random}}};

const QuantityWord* find_word(std::string_view text) {
    const auto* const found =
        std::find_if(words.begin(), words.end(), [&](const QuantityWord& word) { return word.text == text; });
    return found == words.end() ? nullptr : found;
}

// Those that take the name of a chemical, in expressions.
constexpr std::string_view before = "previous";
constexpr std::array<QuantityWord, 7> of_chemicals{{{"conc", Quantity::concentration},
                                                    {before, Quantity::concentration},
                                                    {"diff", Quantity::rate},
                                                    {"laplacian", Quantity::laplacian},
                                                    {"gradient_x", Quantity::gradient_x},
                                                    {"gradient_y", Quantity::gradient_y},
                                                    {"gradient_z", Quantity::gradient_z}}};

const QuantityWord* find_of_chemical(std::string_view text) {
    const auto* const found = std::ranges::find(of_chemicals, text, &QuantityWord::text);
    return found == of_chemicals.end() ? nullptr : found;
}

bool needs_lattice(Quantity quantity) {
    switch (quantity) {
        case Quantity::row:
        case Quantity::column:
        case Quantity::rows:
        case Quantity::columns:
        case Quantity::gradient_x:
        case Quantity::gradient_y:
        case Quantity::stencil:
            return true;
        default:
            return false;
    }
}

bool needs_volume(Quantity quantity) {
    return quantity == Quantity::layer || quantity == Quantity::layers || quantity == Quantity::gradient_z;
}

void note_needs(Script& script, const Cursor& cursor, const Token& at, Quantity quantity) {
    if (needs_lattice(quantity)) script.needs_lattice(cursor, at);
    if (needs_volume(quantity)) script.needs_volume(cursor, at);
    if (quantity == Quantity::z) script.needs_depth(cursor, at);
    if (quantity == Quantity::laplacian) script.needs_places(cursor, at);
}

[[noreturn]] void unknown_operand(const Script& script, const Cursor& cursor, std::string_view what) {
    const Token& token = cursor.peek();
    std::vector<std::string_view> allowed{"a number"};
    for (const Parameter& one : script.experiment.parameters) allowed.push_back(one.name);
    for (const QuantityWord& word : words) allowed.push_back(word.text);
    const std::string named = listed(script.chemical_names());
    const std::string chemicals = fmt::format("conc or diff of a chemical ({})", named);
    allowed.push_back(chemicals);
    allowed.push_back("an expression in parentheses");
    for (const std::string& name : script.experiment.mappings) allowed.push_back(name);
    for (const std::string_view name : script.field_names()) allowed.push_back(name);
    const std::string must = fmt::format("{} must be one of: {}", what, listed(allowed));
    if (cursor.done()) cursor.fail(token, fmt::format("the line ends too early; {}", must));
    for (const std::string_view name : script.chemical_names()) allowed.push_back(name);
    cursor.fail(token, fmt::format("unknown name {}; {}{}", Cursor::shown(token), must,
                                   token.quoted ? "" : suggestion(token.text, allowed)));
}

// What rules know.
class KnownNames final : public Names {
public:
    KnownNames(Script& script, const Cursor& cursor, Scope scope) : script_(script), cursor_(cursor), scope_(scope) {}

    std::optional<Operand> find(const Token& at) const override {
        const auto operand = known(at);
        if (operand) check_scope(at, operand->quantity);
        return operand;
    }
    bool takes_chemical(std::string_view word) const override {
        return find_of_chemical(word) != nullptr || script_.find_stencil(word).has_value();
    }
    std::optional<Operand> of_chemical(const Token& word, const Token& name) const override {
        const auto chemical = script_.find_chemical(name.text);
        if (!chemical) return std::nullopt;
        if (const auto stencil = script_.find_stencil(word.text)) {
            check_scope(word, Quantity::stencil);
            return Operand{Quantity::stencil, 0.0, *chemical, *stencil};
        }
        const Quantity quantity = find_of_chemical(word.text)->quantity;
        check_scope(word, quantity);
        note_needs(script_, cursor_, word, quantity);
        if (word.text == before) {
            if (!visible(Quantity::mapping)) cursor_.fail(word, "'previous' is known in rules alone, not at the start");
            return Operand{quantity, 0.0, script_.previous_of(*chemical, cursor_, word)};
        }
        return Operand{quantity, 0.0, *chemical};
    }
    std::vector<std::string_view> chemical_words() const override {
        std::vector<std::string_view> names;
        for (const QuantityWord& word : of_chemicals) {
            if (visible(word.quantity) && scope_ != Scope::field) names.push_back(word.text);
        }
        for (const NamedStencil& one : script_.experiment.stencils) {
            if (visible(Quantity::stencil)) names.push_back(one.name);
        }
        return names;
    }
    std::vector<std::string_view> all() const override {
        std::vector<std::string_view> names;
        if (scope_ != Scope::field) names = script_.chemical_names();
        if (visible(Quantity::mapping)) {
            for (const std::string& name : script_.experiment.mappings) names.push_back(name);
        }
        for (const std::string_view name : script_.field_names()) names.push_back(name);
        for (const Parameter& one : script_.experiment.parameters) names.push_back(one.name);
        for (const QuantityWord& word : words) {
            if (visible(word.quantity)) names.push_back(word.text);
        }
        return names;
    }

private:
    bool visible(Quantity quantity) const {
        if (scope_ == Scope::field) return seen_by_field(quantity);
        return scope_ != Scope::start || seen_at_start(quantity);
    }
    void check_scope(const Token& at, Quantity quantity) const {
        if (visible(quantity)) return;
        cursor_.fail(at,
                     scope_ == Scope::field
                         ? fmt::format("{} changes while the experiment runs; a field is computed once, from the place",
                                       Cursor::shown(at))
                         : fmt::format("{} is known in rules alone, not at the start", Cursor::shown(at)));
    }

    std::optional<Operand> known(const Token& at) const {
        if (const auto chemical = script_.find_chemical(at.text)) return Operand::concentration(*chemical);
        if (const auto mapping = script_.find_mapping(at.text)) return Operand{Quantity::mapping, 0.0, *mapping};
        if (const auto field = script_.find_field(at.text)) return Operand{Quantity::field, 0.0, *field};
        if (const Parameter* parameter = cursor_.parameter(at)) return Operand::number(parameter->value);
        if (const QuantityWord* word = find_word(at.text)) {
            note_needs(script_, cursor_, at, word->quantity);
            return Operand{word->quantity, 0.0, 0};
        }
        return std::nullopt;
    }

    Script& script_;
    const Cursor& cursor_;
    Scope scope_;
};

// Words of volumes alone may be names, too: chemicals of published files may have them.
bool may_be_name(Quantity quantity) {
    return quantity == Quantity::z || quantity == Quantity::layer || quantity == Quantity::layers;
}

bool named_otherwise(const Script& script, const Cursor& cursor, const Token& at) {
    return script.find_mapping(at.text) || script.find_field(at.text) || cursor.parameter(at) != nullptr;
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

std::vector<std::string_view> words_of_chemicals() {
    std::vector<std::string_view> texts;
    for (const QuantityWord& word : of_chemicals) texts.push_back(word.text);
    return texts;
}

Operand parse_operand(Script& script, Cursor& cursor, std::string_view what) {
    static constexpr std::array<std::string_view, 2> targets{"conc", "diff"};
    const Token& token = cursor.peek();
    if (cursor.done() || token.quoted) unknown_operand(script, cursor, what);
    if (is_expression(token)) {
        Expression expression = parse_expression(script, cursor, Scope::rule, what);
        if (expression.nodes.size() == 1) return expression.nodes[0].operand;
        return {Quantity::expression, 0.0, keep_expression(script, cursor, token, std::move(expression))};
    }
    if (const auto chemical = script.find_chemical(token.text)) {
        cursor.next();
        return cursor.choose(targets) == 0 ? Operand::concentration(*chemical) : Operand::rate(*chemical);
    }
    const QuantityWord* word = find_word(token.text);
    if (word != nullptr && !named_otherwise(script, cursor, token)) {
        note_needs(script, cursor, token, word->quantity);
        cursor.next();
        return {word->quantity, 0.0, 0};
    }
    if (const auto mapping = script.find_mapping(token.text)) {
        cursor.next();
        return {Quantity::mapping, 0.0, *mapping};
    }
    if (const auto field = script.find_field(token.text)) {
        cursor.next();
        return {Quantity::field, 0.0, *field};
    }
    if (!numeric(token.text) && cursor.parameter(token) == nullptr) unknown_operand(script, cursor, what);
    return Operand::number(cursor.number(what));
}

Expression parse_expression(Script& script, Cursor& cursor, Scope scope, std::string_view what) {
    const Token& token = cursor.peek();
    if (cursor.done() || !is_expression(token))
        cursor.fail(token, fmt::format("{} must be an expression in parentheses", what));
    Expression expression = read_expression(cursor, token, KnownNames(script, cursor, scope));
    expression.line = cursor.line();
    cursor.next();
    return expression;
}

std::size_t keep_expression(Script& script, const Cursor& cursor, const Token& at, Expression expression) {
    auto& all = script.experiment.expressions;
    if (all.size() == largest_expression_count)
        cursor.fail(at, fmt::format("one expression too many; at most {} are allowed", largest_expression_count));
    all.push_back(std::move(expression));
    return all.size() - 1;
}

namespace {

// Throws Error where something has the name already.
void check_new(const Script& script, const Cursor& cursor, const Token& name, std::string_view what) {
    const auto taken = [&](bool found, std::string_view by) {
        if (!found) return;
        cursor.fail(name, by == what ? fmt::format("{} '{}' is defined already", by, name.text)
                                     : fmt::format("'{}' is a {}; choose another name", name.text, by));
    };
    taken(script.find_chemical(name.text).has_value(), "chemical");
    taken(script.find_mapping(name.text).has_value(), "mapping");
    taken(script.find_field(name.text).has_value(), "field");
    taken(script.find_stencil(name.text).has_value(), "stencil");
    taken(cursor.parameter(name) != nullptr, "parameter");
}

}  // namespace

void check_name(const Script& script, const Cursor& cursor, const Token& name, std::string_view what) {
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
    const bool mistakable =
        what == "parameter" || what == "field" || what == "stencil";  // chemicals of published files may be named so
    if (mistakable && std::ranges::find(own_words, text) != own_words.end())
        cursor.fail(name, fmt::format("'{}' cannot name a {}; it is a word of expressions", text, what));
    const bool taken = find_of_chemical(text) != nullptr ||
                       std::ranges::find(function_table(), text, &FunctionFacts::name) != function_table().end();
    if (what == "stencil" && taken)
        cursor.fail(name, fmt::format("'{}' cannot name a stencil; it is a function", text));
    const QuantityWord* word_of_rules = find_word(text);
    if (word_of_rules != nullptr && !may_be_name(word_of_rules->quantity)) {
        cursor.fail(name, fmt::format("'{}' cannot name a {}; it is a word of rules", text, what));
    }
    check_new(script, cursor, name, what);
}

}  // namespace pelage::language
