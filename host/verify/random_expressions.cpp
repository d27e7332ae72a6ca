// Expressions of a random experiment: deep and wide, of all operators and functions.
#include "core/error.hpp"
#include "core/functions.hpp"
#include "language/expression.hpp"
#include "verify/random_draft.hpp"

#include <fmt/format.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pelage::verify {

namespace {

// What is read of the cells around.
std::string around(Draft& draft) {
    std::vector<std::string> words{"laplacian"};
    if (draft.grid()) words.insert(words.end(), {"gradient_x", "gradient_y"});
    if (draft.kind == TissueKind::volume) words.emplace_back("gradient_z");
    words.insert(words.end(), draft.stencils.begin(), draft.stencils.end());
    words.insert(words.end(), draft.stencils.begin(), draft.stencils.end());
    const std::string& word = words[draft.dice.below(words.size())];
    return fmt::format("{}({})", word, draft.any_chemical().name);
}

std::string place(Draft& draft) {
    std::vector<std::string> words{"X", "Y"};
    if (draft.grid()) words.insert(words.end(), {"ROW", "COLUMN", "ROWS", "COLUMNS"});
    if (draft.kind == TissueKind::volume) words.insert(words.end(), {"Z", "LAYER", "LAYERS"});
    if (draft.kind == TissueKind::mesh) words.emplace_back("Z");
    return words[draft.dice.below(words.size())];
}

std::string leaf(Draft& draft, ExpressionScope scope) {
    Dice& dice = draft.dice;
    const bool rule = scope == ExpressionScope::rule;
    if (rule && draft.kind != TissueKind::free_cells && dice.chance(10)) return around(draft);
    const unsigned fields = static_cast<unsigned>(draft.fields.size());
    const unsigned mappings = rule ? static_cast<unsigned>(draft.mappings.size()) : 0;
    switch (dice.weighted({rule ? 12u : 0u, rule ? 3u : 0u, 6, 4, rule ? 5u : 0u, 2, 2 * fields, mappings})) {
        case 0:
            return draft.any_chemical().name;
        case 1:
            return fmt::format("diff({})", draft.any_chemical().name);
        case 2:
            return dice.number(0.125, 3.0);
        case 3:
            return place(draft);
        case 4:
            return dice.pick({"ITERATION", "TIME", "AGE", "BIRTH", "NEIGHBORS"});
        case 5:
            return scope == ExpressionScope::field && !draft.grid() ? "PI" : dice.pick({"RANDOM", "PI"});
        case 6:
            return draft.fields[dice.below(draft.fields.size())];
        default:
            return draft.mappings[dice.below(draft.mappings.size())].name;
    }
}

std::string expression(Draft& draft, ExpressionScope scope, unsigned depth);

std::string call(Draft& draft, ExpressionScope scope, unsigned depth) {
    const FunctionFacts& function = function_table()[draft.dice.below(function_table().size())];
    std::string text = function.name + "(";
    for (std::size_t i = 0; i < function.parameters.size(); ++i) {
        if (i > 0) text += ", ";
        text += expression(draft, scope, depth);
    }
    return text + ")";
}

std::string truth(Draft& draft, ExpressionScope scope, unsigned depth) {
    Dice& dice = draft.dice;
    if (depth > 0 && dice.chance(25)) {
        const std::string left = truth(draft, scope, depth - 1);
        if (dice.chance(30)) return "not (" + left + ")";
        const char* const word = dice.pick({"and", "or"});
        return fmt::format("{} {} {}", left, word, truth(draft, scope, depth - 1));
    }
    const std::string left = expression(draft, scope, depth);
    const char* const sign = dice.pick({"==", "!=", "<", "<=", ">", ">="});
    return fmt::format("{} {} {}", left, sign, expression(draft, scope, depth));
}

std::string expression(Draft& draft, ExpressionScope scope, unsigned depth) {
    Dice& dice = draft.dice;
    if (depth == 0) return leaf(draft, scope);
    const unsigned below = depth - 1;
    switch (dice.weighted({10, 40, 8, 6, 10, 22})) {
        case 0:
            return leaf(draft, scope);
        case 1: {
            const std::string left = expression(draft, scope, below);
            const char* const sign = dice.pick({"+", "-", "*", "/"});
            return fmt::format("({} {} {})", left, sign, expression(draft, scope, below));
        }
        case 2:
            return "-" + expression(draft, scope, below);
        case 3: {
            const std::string base = expression(draft, scope, below);
            const char* const exponent = dice.pick({"2", "3", "4", "0.5", "(-1)"});
            return fmt::format("({})^{}", base, exponent);
        }
        case 4: {
            const std::string which = truth(draft, scope, below);
            const std::string yes = expression(draft, scope, below);
            return fmt::format("if({}, {}, {})", which, yes, expression(draft, scope, below));
        }
        default:
            return call(draft, scope, below);
    }
}

// Every name stands for something that is not known yet.
class AnyNames final : public language::Names {
public:
    std::optional<Operand> find(const language::Token& at) const override {
        if (at.text == "PI") return std::nullopt;
        return Operand{Quantity::x, 0.0, 0};
    }
    std::vector<std::string_view> chemical_words() const override { return {}; }
    bool takes_chemical(std::string_view word) const override {
        return word == "diff" || word == "laplacian" || word.starts_with("gradient_") || word.starts_with("around_");
    }
    std::optional<Operand> of_chemical(const language::Token&, const language::Token& name) const override {
        return find(name);
    }
    std::vector<std::string_view> all() const override { return {}; }
};

// Whether it can be read: 1 / (2 - 2) cannot.
bool makes_sense(const std::string& text) {
    try {
        static const std::vector<Parameter> none;
        const language::Cursor cursor("drawn:1", 1, text, none);
        (void)language::read_expression(cursor, cursor.peek(), AnyNames());
        return true;
    } catch (const Error&) {
        return false;
    }
}

std::string sensible(Draft& draft, ExpressionScope scope) {
    const auto depth = static_cast<unsigned>(draft.dice.from_to(1, 4));
    for (int trial = 0; trial < 20; ++trial) {
        std::string text = expression(draft, scope, depth);
        if (makes_sense("(" + text + ")")) return text;
    }
    return leaf(draft, scope);
}

}  // namespace

std::string draw_expression(Draft& draft, ExpressionScope scope, double low, double high) {
    const std::string inside = sensible(draft, scope);
    const std::string least = draft.dice.number(low);
    return fmt::format("(min({2}, max({1}, {0})))", inside, least, draft.dice.number(high));  // NaN gives `least`
}

std::string draw_truth(Draft& draft) {
    std::string text = "(" + truth(draft, ExpressionScope::rule, 2) + ")";
    return makes_sense(text) ? text : fmt::format("({} > 1)", draft.any_chemical().name);
}

}  // namespace pelage::verify
