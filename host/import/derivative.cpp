// See derivative.hpp.
#include "import/derivative.hpp"

#include <vector>

namespace pelage::imports {

namespace {

TermRef square_of(const TermRef& a) { return call_term("^", {a, number_term(2.0)}); }

// Of a function of one argument, at that argument.
std::optional<TermRef> outer_derivative(const std::string& function, const TermRef& a) {
    if (function == "exp") return call_term("exp", {a});
    if (function == "log") return over(number_term(1.0), a);
    if (function == "sqrt") return over(number_term(0.5), call_term("sqrt", {a}));
    if (function == "sin") return call_term("cos", {a});
    if (function == "cos") return negated(call_term("sin", {a}));
    if (function == "tanh") return minus(number_term(1.0), square_of(call_term("tanh", {a})));
    if (function == "floor" || function == "ceil" || function == "round" || function == "not") return number_term(0.0);
    if (function == "abs") return choice(call_term("<", {a, number_term(0.0)}), number_term(-1.0), number_term(1.0));
    return std::nullopt;
}

// Of a function of two arguments whose derivatives are given.
std::optional<TermRef> of_two(const Term& term, const TermRef& da, const TermRef& db) {
    const TermRef &a = term.arguments[0], &b = term.arguments[1];
    const std::string& is = term.text;
    if (is == "+") return plus(da, db);
    if (is == "-") return minus(da, db);
    if (is == "*") return plus(times(da, b), times(a, db));
    if (is == "/") return minus(over(da, b), over(times(a, db), square_of(b)));
    if (is == "min") return choice(call_term("<", {b, a}), db, da);
    if (is == "max") return choice(call_term(">", {b, a}), db, da);
    if ((is == "^" || is == "pow") && is_number(db, 0.0))
        return times(times(b, call_term("pow", {a, minus(b, number_term(1.0))})), da);
    return std::nullopt;
}

}  // namespace

std::optional<TermRef> derivative(const TermRef& term, const std::string& name) {
    if (!mentions(term, name) || is_truth(term)) return number_term(0.0);
    if (is_name(term)) return number_term(1.0);
    if (term->text == "laplacian" || term->text == "gradient_x" || term->text == "gradient_y") return std::nullopt;
    std::vector<TermRef> inner;
    for (const TermRef& one : term->arguments) {
        const auto slope = derivative(one, name);
        if (!slope) return std::nullopt;
        inner.push_back(*slope);
    }
    if (term->text == "negate") return negated(inner[0]);
    if (term->text == "if") return choice(term->arguments[0], inner[1], inner[2]);
    if (inner.size() == 2) return of_two(*term, inner[0], inner[1]);
    if (inner.size() != 1) return std::nullopt;
    const auto outer = outer_derivative(term->text, term->arguments[0]);
    if (!outer) return std::nullopt;
    return times(*outer, inner[0]);
}

}  // namespace pelage::imports
