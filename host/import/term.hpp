// Formulas of other programs as trees, in the words of the experiment language.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace pelage::imports {

struct Term;
using TermRef = std::shared_ptr<const Term>;

// A number (no text), a name (text alone), or an operation: "+", "-", "*", "/", "^", "negate", "not", "and", "or", "<",
// "if", ... or a function of the experiment language; "laplacian", "gradient_x", "gradient_y" take a chemical's name.
struct Term {
    double value = 0.0;
    std::string text;
    std::vector<TermRef> arguments;
    std::size_t size = 1;  // nodes
    std::size_t depth = 1;
};

// A tree may have this many nodes and levels; the makers throw Error beyond.
inline constexpr std::size_t largest_term = 4'000;
inline constexpr std::size_t deepest_term = 400;

TermRef number_term(double);
TermRef name_term(std::string_view);
TermRef call_term(std::string_view operation, std::vector<TermRef> arguments);

// Sums and products leave out what changes nothing: + 0, * 1, * 0.
TermRef plus(const TermRef&, const TermRef&);
TermRef minus(const TermRef&, const TermRef&);
TermRef times(const TermRef&, const TermRef&);
TermRef over(const TermRef&, const TermRef&);
TermRef negated(const TermRef&);
TermRef choice(const TermRef& truth, const TermRef& then, const TermRef& otherwise);

bool is_number(const TermRef&, double);
bool is_leaf_number(const TermRef&);
bool is_name(const TermRef&);
bool is_truth(const TermRef&);  // a comparison, and, or, not
bool of_names_only(const TermRef&,
                   const std::function<bool(const std::string&)>& allowed);  // and of no chemical's slopes
bool mentions(const TermRef&, std::string_view name);  // as a name, a function or a slope of that chemical

// Of arithmetic, functions of one or two arguments and names with values; NaN where that cannot be told.
double value_of(const TermRef&, const std::function<double(const std::string&)>& of_name);

// As the experiment language writes it, without the outer parentheses.
std::string text_of(const TermRef&);

std::string number_text(double);

}  // namespace pelage::imports
