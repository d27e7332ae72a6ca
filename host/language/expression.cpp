// See expression.hpp: a recursive descent, one function for each level of precedence.
#include "language/expression.hpp"

#include "core/evaluate.hpp"
#include "core/functions.hpp"
#include "language/pieces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace pelage::language {

namespace {

constexpr int deepest = 100;  // parentheses in parentheses

class Reader {
public:
    Reader(const Cursor& cursor, const Token& token, const Names& names)
        : token_(token), names_(names), pieces_(cursor, token, names) {}

    Expression read() {
        value();  // of the parentheses that the token begins and ends with
        if (!pieces_.done())
            pieces_.fail(pieces_.now(), fmt::format("{} follows an expression that is complete", shown(pieces_.now())));
        return {std::string(token_.text), std::move(nodes_)};
    }

private:
    using Place = std::size_t;

    static std::string shown(const Token& token) { return fmt::format("'{}'", shortened(token.text)); }

    // ---- levels of precedence, the loosest first

    Place value() {
        Place left = both();
        while (true) {
            const Token at = pieces_.now();
            if (!pieces_.take("or")) return left;
            left = add(at, Operation::disjunction, {left, both()});
        }
    }

    Place both() {
        Place left = contrary();
        while (true) {
            const Token at = pieces_.now();
            if (!pieces_.take("and")) return left;
            left = add(at, Operation::conjunction, {left, contrary()});
        }
    }

    Place contrary() {
        const Deeper deeper(*this);
        const Token at = pieces_.now();
        if (!pieces_.take("not")) return comparison();
        return add(at, Operation::negation, {contrary()});
    }

    Place comparison() {
        const Place left = sum();
        const Token at = pieces_.now();
        const auto which = taken_comparison();
        if (!which) return left;
        const Place right = sum();
        const Place result = add(at, Operation::compare, {left, right}, *which);
        const Token again = pieces_.now();
        if (taken_comparison()) pieces_.fail(again, "comparisons do not chain; write 'a < b and b < c'");
        return result;
    }

    std::optional<Comparison> taken_comparison() {
        static constexpr std::array<std::string_view, 6> signs{"==", "!=", "<", "<=", ">", ">="};
        static constexpr std::array comparisons{Comparison::equal,   Comparison::not_equal,
                                                Comparison::less,    Comparison::less_equal,
                                                Comparison::greater, Comparison::greater_equal};
        for (std::size_t i = 0; i < signs.size(); ++i) {
            if (pieces_.take(signs[i])) return comparisons[i];
        }
        return std::nullopt;
    }

    Place sum() {
        Place left = product();
        while (true) {
            const Token at = pieces_.now();
            if (pieces_.take("+"))
                left = add(at, Operation::add, {left, product()});
            else if (pieces_.take("-"))
                left = add(at, Operation::subtract, {left, product()});
            else
                return left;
        }
    }

    Place product() {
        Place left = signed_value();
        while (true) {
            const Token at = pieces_.now();
            if (pieces_.take("*"))
                left = add(at, Operation::multiply, {left, signed_value()});
            else if (pieces_.take("/"))
                left = add(at, Operation::divide, {left, signed_value()});
            else
                return left;
        }
    }

    Place signed_value() {
        const Deeper deeper(*this);
        const Token at = pieces_.now();
        if (pieces_.take("+")) return signed_value();
        if (!pieces_.take("-")) return power();
        return add(at, Operation::negate, {signed_value()});
    }

    // a ^ b ^ c is a ^ (b ^ c), and -a ^ b is -(a ^ b).
    Place power() {
        const Place base = atom();
        const Token at = pieces_.now();
        if (!pieces_.take("^")) return base;
        if (const auto exponent = small_exponent()) return repeated(at, base, *exponent);
        return call(at, "pow", {base, signed_value()});
    }

    // An exponent written as 2, 3 or 4, with nothing bound to it.
    std::optional<int> small_exponent() {
        const std::string_view text = pieces_.now().text;
        if (text != "2" && text != "3" && text != "4") return std::nullopt;
        Pieces ahead = pieces_;
        ahead.next();
        if (ahead.now().text == "^") return std::nullopt;
        pieces_.next();
        return text[0] - '0';
    }

    Place repeated(const Token& at, Place base, int exponent) {
        const Place square = multiply_unfolded(at, base, base);
        if (exponent == 2) return fold_tail(at, base, square);
        const Place result = multiply_unfolded(at, square, exponent == 3 ? base : square);
        return fold_tail(at, base, result);
    }

    // A product of a node with itself: its arguments are not the last nodes one after another.
    Place multiply_unfolded(const Token& at, Place left, Place right) {
        return append(at, {Operation::multiply, {}, {}, 0, {left, right}});
    }

    // Where `base` is a number, so is what has been made of it.
    Place fold_tail(const Token& at, Place base, Place last) {
        if (!number_at(base)) return last;
        double power = *number_at(base);
        const double one = power;
        for (Place n = base + 1; n <= last; ++n) {
            const auto& arguments = nodes_[n].arguments;
            power = arguments[1] == base ? power * one : power * power;
        }
        nodes_.resize(base);
        return append_number(at, power);
    }

    Place atom() {
        const Deeper deeper(*this);
        const Token at = pieces_.now();
        if (pieces_.done()) pieces_.fail(at, "the expression ends too early; a value is missing here");
        if (pieces_.take("(")) return closed(at);
        const char first = at.text[0];
        if (is_digit(first) || first == '.') return number();
        if (starts_name(first)) return named();
        pieces_.fail(at, fmt::format("{} cannot stand here; a value must: a number, a name, a function or '('{}",
                                     shown(at), hint(at.text)));
    }

    Place closed(const Token& opening) {
        const Place inside = value();
        if (pieces_.take(")")) return inside;
        if (pieces_.done()) pieces_.fail(opening, "this parenthesis is not closed");
        pieces_.fail(pieces_.now(), fmt::format("{} follows a value; an operator or ')' must{}", shown(pieces_.now()),
                                                hint(pieces_.now().text)));
    }

    static std::string_view hint(std::string_view found) {
        if (found == "=") return "; equality is '=='";
        if (found == "&&" || found == "&") return "; write 'and'";
        if (found == "||" || found == "|") return "; write 'or'";
        if (found == "!") return "; write 'not'";
        if (found == "**") return "; a power is '^'";
        if (found == "%") return "; write 'mod(a, b)'";
        return "";
    }

    Place number() {
        const Token at = pieces_.next();
        const std::optional<double> value = to_number(at.text);
        if (!value) pieces_.fail(at, fmt::format("{} is no number that a float can hold", shown(at)));
        const Token& after = pieces_.now();
        const bool touches = after.offset == at.offset + at.text.size() && !after.text.empty();
        if (touches && (starts_name(after.text[0]) || after.text[0] == '(' || after.text[0] == '.'))
            pieces_.fail(after, fmt::format("{} follows a number; a product needs its '*'", shown(after)));
        return append_number(at, *value);
    }

    Place named() {
        const Token at = pieces_.next();
        if (at.text == "if") return choice(at);
        if (at.text == "and" || at.text == "or" || at.text == "not")
            pieces_.fail(at, fmt::format("{} stands between truths; a value is missing before it", shown(at)));
        if (pieces_.now().text == "(") return names_.takes_chemical(at.text) ? of_chemical(at) : function(at);
        if (const auto operand = names_.find(at)) return append_operand(at, *operand);
        if (at.text == "PI") return append_number(at, std::numbers::pi);
        if (function_named(at.text))
            pieces_.fail(at, fmt::format("{} is a function; write {}(...)", shown(at), at.text));
        unknown(at);
    }

    [[noreturn]] void unknown(const Token& at) const {
        std::vector<std::string_view> all = names_.all();
        all.insert(all.end(), own_words.begin(), own_words.end());
        const std::string names = listed(all);
        const std::vector<std::string_view> words = names_.chemical_words();
        if (std::ranges::find(words, at.text) != words.end())
            pieces_.fail(at, fmt::format("'{}' takes the name of a chemical; write {}(NAME)", at.text, at.text));
        for (const FunctionFacts& facts : function_table()) all.push_back(facts.name);
        pieces_.fail(at, fmt::format("unknown name {} in an expression; known here: {}, and functions{}", shown(at),
                                     names, suggestion(at.text, all)));
    }

    Place of_chemical(const Token& word) {
        pieces_.take("(");
        const Token name = pieces_.next();
        const auto operand = name.text.empty() ? std::nullopt : names_.of_chemical(word, name);
        if (!operand)
            pieces_.fail(name, fmt::format("'{}' takes the name of a chemical; found {}", word.text, shown(name)));
        if (!pieces_.take(")")) pieces_.fail(pieces_.now(), fmt::format("'{}(NAME' is not closed", word.text));
        return append_operand(word, *operand);
    }

    Place function(const Token& word) {
        const auto index = function_named(word.text);
        if (!index) unknown_function(word);
        return append_call(word, *index, arguments(word, function_table()[*index].parameters));
    }

    [[noreturn]] void unknown_function(const Token& word) const {
        std::vector<std::string_view> names = names_.chemical_words();
        names.push_back("if");
        for (const FunctionFacts& facts : function_table()) names.push_back(facts.name);
        if (names_.find(word))
            pieces_.fail(word, fmt::format("{} is no function; a product needs its '*'", shown(word)));
        pieces_.fail(word, fmt::format("unknown function {}; there are: {}{}", shown(word), listed(names),
                                       suggestion(word.text, names)));
    }

    // Between parentheses, as many as there are names.
    std::vector<Place> arguments(const Token& word, const std::vector<std::string>& wanted) {
        pieces_.take("(");
        std::vector<Place> places;
        const auto fail_count = [&](const Token& at) {
            pieces_.fail(at, fmt::format("{}({}) takes {} value{}", word.text, fmt::join(wanted, ", "), wanted.size(),
                                         wanted.size() == 1 ? "" : "s"));
        };
        while (true) {
            if (pieces_.now().text == ")") fail_count(pieces_.now());
            places.push_back(value());
            const Token at = pieces_.now();
            if (pieces_.take(")")) {
                if (places.size() != wanted.size()) fail_count(at);
                return places;
            }
            if (pieces_.done()) pieces_.fail(word, fmt::format("the parenthesis after {} is not closed", shown(word)));
            if (!pieces_.take(","))
                pieces_.fail(at, fmt::format("{} follows a value; ',' or ')' must{}", shown(at), hint(at.text)));
            if (places.size() == wanted.size()) fail_count(at);
        }
    }

    Place choice(const Token& word) {
        if (pieces_.now().text != "(") pieces_.fail(word, "'if' is written if(TRUTH, VALUE, OTHERWISE)");
        const std::vector<std::string> wanted{"TRUTH", "VALUE", "OTHERWISE"};
        return add(word, Operation::choice, arguments(word, wanted));
    }

    // ---- nodes

    Place call(const Token& at, std::string_view function, std::vector<Place> arguments) {
        return append_call(at, *function_named(function), std::move(arguments));
    }
    Place append_call(const Token& at, std::size_t function, std::vector<Place> arguments) {
        return folded(at, {Operation::call, {}, {}, function, std::move(arguments)});
    }
    Place add(const Token& at, Operation operation, std::vector<Place> arguments, Comparison comparison = {}) {
        return folded(at, {operation, {}, comparison, 0, std::move(arguments)});
    }

    // A node of numbers alone is a number. They are then the last nodes of all.
    Place folded(const Token& at, ExpressionNode node) {
        std::vector<double> numbers;
        for (const Place place : node.arguments) {
            if (const double* number = number_at(place)) numbers.push_back(*number);
        }
        if (numbers.size() != node.arguments.size()) return append(at, std::move(node));
        const double value = evaluate_node(node, numbers);
        nodes_.resize(nodes_.size() - node.arguments.size());
        return append_number(at, value);
    }

    const double* number_at(Place place) const {
        const ExpressionNode& node = nodes_[place];
        const bool number = node.operation == Operation::operand && node.operand.quantity == Quantity::number;
        return number ? &node.operand.value : nullptr;
    }

    Place append_number(const Token& at, double value) {
        if (std::isnan(value)) pieces_.fail(at, fmt::format("{} gives no number here", shown(at)));
        if (std::isinf(value) || std::fabs(value) > double{std::numeric_limits<float>::max()})
            pieces_.fail(at, fmt::format("{} gives {:g} here, which no number of a run can be", shown(at), value));
        return append_operand(at, Operand::number(value));
    }
    Place append_operand(const Token& at, const Operand& operand) {
        return append(at, {Operation::operand, operand, {}, 0, {}});
    }
    Place append(const Token& at, ExpressionNode node) {
        if (nodes_.size() == largest_node_count)
            pieces_.fail(at, fmt::format("the expression is too long; at most {} values and operators are allowed",
                                         largest_node_count));
        nodes_.push_back(std::move(node));
        return nodes_.size() - 1;
    }

    // Lives as long as one more level of the expression is being read.
    class Deeper {
    public:
        explicit Deeper(Reader& reader) : reader_(reader) {
            if (++reader_.depth_ > 4 * deepest)
                reader_.pieces_.fail(
                    reader_.pieces_.now(),
                    fmt::format("the expression is nested too deeply; at most {} levels are allowed", deepest));
        }
        ~Deeper() { --reader_.depth_; }
        Deeper(const Deeper&) = delete;
        Deeper& operator=(const Deeper&) = delete;

    private:
        Reader& reader_;
    };

    const Token& token_;
    const Names& names_;
    Pieces pieces_;
    std::vector<ExpressionNode> nodes_;
    int depth_ = 0;
};

}  // namespace

bool is_expression(const Token& token) { return !token.quoted && token.text.starts_with('('); }

Expression read_expression(const Cursor& cursor, const Token& token, const Names& names) {
    return Reader(cursor, token, names).read();
}

}  // namespace pelage::language
