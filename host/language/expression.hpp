// Expressions in parentheses, as the language writes them, read into trees. See docs/language.md, "Expressions".
#pragma once

#include "core/expression.hpp"
#include "language/cursor.hpp"

#include <array>
#include <optional>
#include <string_view>
#include <vector>

namespace pelage::language {

// Words that mean something in expressions alone.
inline constexpr std::array<std::string_view, 5> own_words{"if", "and", "or", "not", "PI"};

// What the names in an expression mean.
class Names {
public:
    virtual ~Names() = default;
    // What a name without parentheses stands for; empty where nothing has it. `at` is where it stands.
    virtual std::optional<Operand> find(const Token& at) const = 0;
    // What `word(NAME)` stands for, where the word takes the name of a chemical and not a value: `diff(U)`. Empty where
    // it is no such word.
    virtual std::optional<Operand> of_chemical(const Token& word, const Token& name) const = 0;
    virtual bool takes_chemical(std::string_view word) const = 0;
    // For messages: words that take the name of a chemical, and all that may stand alone.
    virtual std::vector<std::string_view> chemical_words() const = 0;
    virtual std::vector<std::string_view> all() const = 0;
};

// Whether a token is an expression: a text in parentheses.
bool is_expression(const Token&);

// Whatever is made of numbers alone is a number of the tree. Throws Error, with line and column, for what is no
// expression.
Expression read_expression(const Cursor&, const Token&, const Names&);

}  // namespace pelage::language
