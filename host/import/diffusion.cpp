// See diffusion.hpp.
#include "import/diffusion.hpp"

#include <optional>

namespace pelage::imports {

namespace {

void collect(const TermRef& term, bool negative, std::vector<std::pair<TermRef, bool>>& all) {
    if (term->text == "+" || (term->text == "-" && term->arguments.size() == 2)) {
        collect(term->arguments[0], negative, all);
        collect(term->arguments[1], term->text == "-" ? !negative : negative, all);
    } else if (term->text == "negate") {
        collect(term->arguments[0], !negative, all);
    } else {
        all.emplace_back(term, negative);
    }
}

// a * (1 / b) is a / b.
TermRef product(const TermRef& a, const TermRef& b) {
    return b->text == "/" && is_number(b->arguments[0], 1.0) ? over(a, b->arguments[1]) : times(a, b);
}

// The factor of the chemical's Laplacian in a product; empty where it is no such product.
std::optional<TermRef> factor_of(const TermRef& term, const std::string& chemical) {
    if (term->text == "laplacian") {
        if (term->arguments[0]->text == chemical) return number_term(1.0);
        return std::nullopt;
    }
    if (term->text == "negate") {
        const auto factor = factor_of(term->arguments[0], chemical);
        if (factor) return negated(*factor);
    }
    if (term->text == "*") {
        if (const auto left = factor_of(term->arguments[0], chemical)) return times(*left, term->arguments[1]);
        if (const auto right = factor_of(term->arguments[1], chemical)) return product(term->arguments[0], *right);
    }
    if (term->text == "/") {
        if (const auto left = factor_of(term->arguments[0], chemical)) return over(*left, term->arguments[1]);
    }
    return std::nullopt;
}

}  // namespace

std::vector<std::pair<TermRef, bool>> summands(const TermRef& term) {
    std::vector<std::pair<TermRef, bool>> all;
    collect(term, false, all);
    return all;
}

void take_diffusion(TermRef& change, DraftChemical& chemical, const std::function<bool(const std::string&)>& constant,
                    const std::function<double(const std::string&)>& value) {
    TermRef rate = number_term(0.0), rest = number_term(0.0);
    for (const auto& [term, negative] : summands(change)) {
        const auto factor = factor_of(term, chemical.name);
        if (factor && of_names_only(*factor, constant))
            rate = negative ? minus(rate, *factor) : plus(rate, *factor);
        else
            rest = negative ? minus(rest, term) : plus(rest, term);
    }
    if (!(value_of(rate, value) > 0.0)) return;
    chemical.rate = plus(chemical.rate, rate);
    change = rest;
}

}  // namespace pelage::imports
