// What an expression is made of: numbers, names, operators, parentheses and commas, from left to right.
#pragma once

#include "language/expression.hpp"

#include <cstddef>
#include <string_view>

namespace pelage::language {

bool is_digit(char);
bool starts_name(char);
bool in_name(char);

// Whether the name stands in the text, with nothing before or behind that would make it another one.
bool names_word(std::string_view text, std::string_view name);

class Pieces {
public:
    Pieces(const Cursor& cursor, const Token& expression, const Names& names);

    const Token& now() const { return now_; }  // an empty one at the end
    bool done() const { return now_.text.empty(); }
    bool take(std::string_view wanted);  // true, having passed it, where this operator or word comes next
    Token next();
    [[noreturn]] void fail(const Token& at, std::string_view what) const { cursor_.fail(at, what); }

private:
    void advance();
    std::size_t length(std::string_view rest) const;
    std::size_t name_length(std::string_view rest) const;

    const Cursor& cursor_;
    std::string_view text_;
    std::size_t offset_;
    const Names& names_;
    std::size_t at_ = 0;
    Token now_;
};

}  // namespace pelage::language
