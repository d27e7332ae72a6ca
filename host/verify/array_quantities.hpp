// What rules of a generated experiment read, as text: each quantity, numbers beside it, and expressions.
#pragma once

#include "verify/array_text.hpp"

#include <cstddef>
#include <string>
#include <string_view>

namespace pelage::verify {

class QuantityWriter {
public:
    QuantityWriter(const GeneratedCase& one, std::size_t rule) : case_(one), nth_(rule) {}

    // Of a value of the factors `amount` and `read`.
    std::string text(const std::string& what) const;
    // The same in a comparison, where concentrations are those of G, which are few numbers.
    std::string compared(const std::string& what) const { return what == "conc" ? "G conc" : text(what); }
    // A number about which the values of that quantity lie.
    double middle(const std::string& what) const;
    // Another quantity: of the same kind, whole or not, or of the other.
    static std::string_view partner(const std::string& what, bool alike);

private:
    double middle_of_place(const std::string& what) const;
    std::string choice() const;
    std::string expression() const;
    std::string around() const;

    const GeneratedCase& case_;
    std::size_t nth_;
};

}  // namespace pelage::verify
