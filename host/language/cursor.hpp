// One line of an experiment as words, read from left to right with errors that say what is allowed.
#pragma once

#include "core/error.hpp"
#include "core/experiment.hpp"
#include "core/parameter.hpp"
#include "language/words.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pelage::language {

struct Token {
    std::string_view text;   // without the quotes
    std::size_t offset = 0;  // of its first byte in the line
    bool quoted = false;
};

struct Place {  // both from 1
    std::size_t line = 0;
    std::size_t column = 0;
};

Error error_at(const Experiment&, Place, std::string_view text);

// Where a parameter stands for a whole number: beyond it doubles are no longer all whole numbers.
inline constexpr double largest_whole = 9007199254740992.0;

inline constexpr double infinity = std::numeric_limits<double>::infinity();

// Allowed values of a number: low <= value <= high, or low < value, in float too, when `above`.
struct Range {
    double low = -infinity;
    double high = infinity;
    bool above = false;
};
inline constexpr Range any_number{};
inline constexpr Range positive{0.0, infinity, true};
inline constexpr Range not_negative{0.0, infinity, false};
inline constexpr Range fraction{0.0, 1.0, false};

// A decimal number that float can hold, with an optional sign; empty when `text` is none.
std::optional<double> to_number(std::string_view text);

class Cursor {
public:
    // Splits the line at spaces and tabs, outside parentheses; "//" starts a comment. Throws Error for control
    // characters, for bytes above 127 outside quotes and for a quote or a parenthesis that is not closed. Names of
    // `parameters` stand for numbers, and so do expressions made of them.
    // `where` is the line's place in messages, as in "cow.pex:3".
    Cursor(std::string where, std::size_t line, std::string_view text, const std::vector<Parameter>& parameters);

    // The text between a token's quotes, a comma being a word of its own.
    Cursor inside(const Token& quoted) const;

    bool done() const { return next_ + 1 == tokens_.size(); }
    const Token& peek() const { return tokens_[next_]; }  // an empty one at the end of the line
    const Token& peek_behind() const { return tokens_[std::min(next_ + 1, tokens_.size() - 1)]; }  // the one after it
    const Token& next();
    bool take(std::string_view word);  // true, having passed it, when it comes next
    void expect(std::string_view word);
    std::size_t choose(Words allowed);  // which of them comes next
    void finish() const;                // throws unless the line ends here

    // `what` is what the value is for, as in "the time step".
    const Token& value(std::string_view what);  // one word without quotes
    double number(std::string_view what, Range = any_number);
    std::uint64_t integer(std::string_view what, std::uint64_t low, std::uint64_t high);
    std::int64_t signed_integer(std::string_view what);
    const Parameter* parameter(const Token&) const;  // that it names; null: none
    const Token& text(std::string_view what);        // in quotes, not empty

    [[noreturn]] void fail(const Token& at, std::string_view text) const;
    [[noreturn]] void unknown(const Token& at, Words allowed, std::string_view end = "") const;

    std::size_t line() const { return line_; }
    Place place(const Token&) const;
    static std::string shown(const Token&);  // as it stands in messages, with its quotes

private:
    Cursor(std::string where, std::size_t line, std::string_view text, const std::vector<Parameter>* parameters,
           std::size_t from, std::size_t to, bool commas);
    bool starts_comment(std::size_t at) const;
    std::size_t end_of_word(std::size_t at, std::size_t to, bool commas) const;
    std::size_t end_of_expression(std::size_t at, std::size_t to) const;
    std::optional<double> computed_here() const;
    void note_whole() const;  // of the parameters that the value here names
    std::optional<double> number_here() const;
    template <class Integer>
    std::optional<Integer> integer_here(std::string_view what, std::string_view kind) const;
    std::string described(const Token&) const;
    std::string meant(const Token&) const;
    void split(std::size_t from, std::size_t to, bool commas);
    std::size_t split_quoted(std::size_t at, std::size_t to);
    void check_byte(std::size_t at, bool ascii) const;
    [[noreturn]] void needs(const Token& at, std::string_view found, std::string_view what,
                            std::string_view kind) const;

    std::string where_;
    std::size_t line_;
    std::string_view text_;
    const std::vector<Parameter>* parameters_;
    std::vector<Token> tokens_;  // the last one marks the end of the line
    std::size_t next_ = 0;
};

// Options of a statement, in any order, each at most once.
class Options {
public:
    explicit Options(Words words) : words_(words) {}

    // Which option comes next; empty at the end of the line. Throws Error for another word or one already given.
    std::optional<std::size_t> next(Cursor&);
    // The same, but empty also before a word that is none of these.
    std::optional<std::size_t> next_if(Cursor&);
    bool given(std::size_t index) const { return (given_ >> index & 1u) != 0; }

private:
    Words words_;
    std::uint32_t given_ = 0;
};

}  // namespace pelage::language
