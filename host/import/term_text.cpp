// Writes terms as the experiment language reads them, with as few parentheses as keep their order.
#include "import/term.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace pelage::imports {

namespace {

// How tightly what an operation writes holds together; operands that hold less tightly need parentheses.
enum Tightness { disjoined, conjoined, denied, compared, summed, multiplied, signed_, raised, whole };

struct Binary {
    std::string_view operation;
    Tightness own, left, right;
};

// The right side of a sum or product is in parentheses when it is a sum or product itself: rounding follows the order.
constexpr std::array<Binary, 13> binaries{{{"or", disjoined, disjoined, conjoined},
                                           {"and", conjoined, conjoined, denied},
                                           {"<", compared, summed, summed},
                                           {"<=", compared, summed, summed},
                                           {">", compared, summed, summed},
                                           {">=", compared, summed, summed},
                                           {"==", compared, summed, summed},
                                           {"!=", compared, summed, summed},
                                           {"+", summed, summed, multiplied},
                                           {"-", summed, summed, multiplied},
                                           {"*", multiplied, multiplied, signed_},
                                           {"/", multiplied, multiplied, signed_},
                                           {"^", raised, whole, raised}}};

std::string written(const TermRef& term, Tightness wanted);

std::string written_call(const Term& term) {
    std::string arguments;
    for (const TermRef& one : term.arguments) {
        if (!arguments.empty()) arguments += ", ";
        arguments += written(one, disjoined);
    }
    return fmt::format("{}({})", term.text, arguments);
}

std::string in_parentheses_if(bool needed, std::string text) { return needed ? "(" + std::move(text) + ")" : text; }

std::string written(const TermRef& term, Tightness wanted) {
    if (is_leaf_number(term)) return number_text(term->value);
    if (is_name(term)) return term->text;
    if (term->text == "negate") return in_parentheses_if(wanted > signed_, "-" + written(term->arguments[0], raised));
    if (term->text == "not") return in_parentheses_if(wanted > denied, "not " + written(term->arguments[0], compared));
    const auto* const found = std::ranges::find(binaries, term->text, &Binary::operation);
    if (found == binaries.end()) return written_call(*term);
    return in_parentheses_if(wanted > found->own, fmt::format("{} {} {}", written(term->arguments[0], found->left),
                                                              term->text, written(term->arguments[1], found->right)));
}

}  // namespace

std::string text_of(const TermRef& term) { return written(term, disjoined); }

std::string number_text(double value) { return fmt::format("{}", value); }

}  // namespace pelage::imports
