// See term.hpp.
#include "import/term.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace pelage::imports {

namespace {

constexpr std::array<std::string_view, 9> truths{"<", "<=", ">", ">=", "==", "!=", "and", "or", "not"};
constexpr std::array<std::string_view, 4> slopes{"laplacian", "gradient_x", "gradient_y", "previous"};

bool is_slope(const TermRef& term) {
    return !term->arguments.empty() && std::ranges::find(slopes, term->text) != slopes.end();
}

double compute(std::string_view name, double a, double b) {
    if (name == "+") return a + b;
    if (name == "-") return a - b;
    if (name == "*") return a * b;
    if (name == "/") return a / b;
    if (name == "^" || name == "pow") return std::pow(a, b);
    if (name == "negate") return -a;
    if (name == "sqrt") return std::sqrt(a);
    if (name == "exp") return std::exp(a);
    if (name == "log") return std::log(a);
    if (name == "sin") return std::sin(a);
    if (name == "cos") return std::cos(a);
    if (name == "tan") return std::tan(a);
    if (name == "tanh") return std::tanh(a);
    if (name == "abs") return std::fabs(a);
    if (name == "floor") return std::floor(a);
    if (name == "ceil") return std::ceil(a);
    if (name == "min") return std::min(a, b);
    if (name == "max") return std::max(a, b);
    return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

TermRef number_term(double value) {
    if (value < 0.0) return call_term("negate", {number_term(-value)});
    auto term = std::make_shared<Term>();
    term->value = value;
    return term;
}

TermRef name_term(std::string_view name) {
    auto term = std::make_shared<Term>();
    term->text = std::string(name);
    return term;
}

TermRef call_term(std::string_view operation, std::vector<TermRef> arguments) {
    auto term = std::make_shared<Term>();
    term->text = std::string(operation);
    for (const TermRef& one : arguments) {
        term->size += one->size;
        term->depth = std::max(term->depth, one->depth + 1);
    }
    term->arguments = std::move(arguments);
    if (term->size > largest_term)
        throw Error(fmt::format("a formula has more than {} parts when its variables are put in", largest_term));
    if (term->depth > deepest_term)
        throw Error(fmt::format("a formula is more than {} levels deep when its variables are put in", deepest_term));
    return term;
}

bool is_leaf_number(const TermRef& term) { return term->text.empty(); }
bool is_number(const TermRef& term, double value) { return is_leaf_number(term) && term->value == value; }
bool is_name(const TermRef& term) { return !term->text.empty() && term->arguments.empty(); }
bool is_truth(const TermRef& term) {
    return !term->arguments.empty() && std::ranges::find(truths, term->text) != truths.end();
}

TermRef plus(const TermRef& a, const TermRef& b) {
    if (is_number(a, 0.0)) return b;
    if (is_number(b, 0.0)) return a;
    if (b->text == "negate") return minus(a, b->arguments[0]);
    return call_term("+", {a, b});
}

TermRef minus(const TermRef& a, const TermRef& b) {
    if (is_number(b, 0.0)) return a;
    if (is_number(a, 0.0)) return negated(b);
    return call_term("-", {a, b});
}

TermRef times(const TermRef& a, const TermRef& b) {
    if (is_number(a, 0.0) || is_number(b, 0.0)) return number_term(0.0);
    if (is_number(a, 1.0)) return b;
    if (is_number(b, 1.0)) return a;
    return call_term("*", {a, b});
}

TermRef over(const TermRef& a, const TermRef& b) {
    if (is_number(b, 1.0)) return a;
    if (is_number(a, 0.0) && !is_number(b, 0.0)) return a;
    return call_term("/", {a, b});
}

TermRef negated(const TermRef& a) {
    if (is_number(a, 0.0)) return a;
    if (a->text == "negate") return a->arguments[0];
    return call_term("negate", {a});
}

TermRef choice(const TermRef& truth, const TermRef& then, const TermRef& otherwise) {
    return then == otherwise ? then : call_term("if", {truth, then, otherwise});
}

bool of_names_only(const TermRef& term, const std::function<bool(const std::string&)>& allowed) {
    if (is_slope(term)) return false;
    if (is_name(term)) return allowed(term->text);
    return std::ranges::all_of(term->arguments, [&](const TermRef& one) { return of_names_only(one, allowed); });
}

bool mentions(const TermRef& term, std::string_view name) {
    return term->text == name ||
           std::ranges::any_of(term->arguments, [&](const TermRef& one) { return mentions(one, name); });
}

double value_of(const TermRef& term, const std::function<double(const std::string&)>& of_name) {
    if (is_leaf_number(term)) return term->value;
    if (is_name(term)) return term->text == "PI" ? std::numbers::pi : of_name(term->text);
    if (term->arguments.size() > 2) return std::numeric_limits<double>::quiet_NaN();
    const double first = value_of(term->arguments[0], of_name);
    return compute(term->text, first, term->arguments.size() == 2 ? value_of(term->arguments[1], of_name) : 0.0);
}

}  // namespace pelage::imports
