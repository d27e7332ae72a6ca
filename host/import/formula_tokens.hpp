// Splits a formula of another program, which looks like C, into words.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace pelage::imports {

struct FormulaToken {
    enum class Kind { number, name, sign, end } kind = Kind::end;
    std::string_view text;
    double value = 0.0;    // of a number
    std::size_t line = 1;  // in the source
};

// Where a formula stands: `name` is that of the file, or of a field of it.
struct FormulaSource {
    std::string name;
    std::size_t first_line = 0;  // 0: the source has no lines of its own
    std::string at(std::size_t line) const;
};

// Comments are left out. Throws Error for what is no word, and beyond 100 000 words.
std::vector<FormulaToken> formula_tokens(std::string_view text, const FormulaSource&);

}  // namespace pelage::imports
