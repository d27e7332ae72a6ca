// Cursor's first half: splitting a line into words.
#include "language/cursor.hpp"

#include <fmt/format.h>

namespace pelage::language {

namespace {

bool blank(char c) { return c == ' ' || c == '\t'; }

}  // namespace

Cursor::Cursor(std::string where, std::size_t line, std::string_view text, const std::vector<Parameter>& parameters)
    : Cursor(std::move(where), line, text, &parameters, 0, text.size(), false) {}

Cursor::Cursor(std::string where, std::size_t line, std::string_view text, const std::vector<Parameter>* parameters,
               std::size_t from, std::size_t to, bool commas)
    : where_(std::move(where)), line_(line), text_(text), parameters_(parameters) {
    split(from, to, commas);
}

Cursor Cursor::inside(const Token& quoted) const {
    const std::size_t from = quoted.offset + 1;
    return {where_, line_, text_, parameters_, from, from + quoted.text.size(), true};
}

void Cursor::split(std::size_t from, std::size_t to, bool commas) {
    std::size_t at = from;
    std::size_t end = from;  // of the last word
    while (at < to && !(starts_comment(at) && !commas)) {
        if (blank(text_[at])) {
            ++at;
        } else if (text_[at] == '"') {
            at = end = split_quoted(at, to);
        } else if (commas && text_[at] == ',') {
            tokens_.push_back({text_.substr(at, 1), at, false});
            end = ++at;
        } else {
            const std::size_t first = at;
            at = end = text_[at] == '(' && !commas ? end_of_expression(at, to) : end_of_word(at, to, commas);
            tokens_.push_back({text_.substr(first, at - first), first, false});
        }
    }
    tokens_.push_back({{}, end, false});
}

bool Cursor::starts_comment(std::size_t at) const { return text_.substr(at, 2) == "//"; }

std::size_t Cursor::end_of_word(std::size_t at, std::size_t to, bool commas) const {
    for (; at < to && !blank(text_[at]) && text_[at] != '"'; ++at) {
        if (commas ? text_[at] == ',' : text_[at] == '(' || starts_comment(at)) break;
        check_byte(at, true);
    }
    return at;
}

// Behind the parenthesis that closes the one at `at`.
std::size_t Cursor::end_of_expression(std::size_t at, std::size_t to) const {
    const Token opening{text_.substr(at, 1), at, false};
    std::size_t open = 0;
    for (; at < to && !starts_comment(at); ++at) {
        if (!blank(text_[at])) check_byte(at, true);
        if (text_[at] == '(') ++open;
        if (text_[at] == ')' && --open == 0) return at + 1;
    }
    fail(opening, "this parenthesis is not closed; expressions end on the same line");
}

std::size_t Cursor::split_quoted(std::size_t at, std::size_t to) {
    const std::size_t close = text_.substr(0, to).find('"', at + 1);
    if (close == std::string_view::npos)
        fail({{}, at, true}, "a quote is not closed; texts end with \" on the same line");
    for (std::size_t i = at + 1; i < close; ++i) check_byte(i, false);
    tokens_.push_back({text_.substr(at + 1, close - at - 1), at, true});
    return close + 1;
}

void Cursor::check_byte(std::size_t at, bool ascii) const {
    const auto byte = static_cast<unsigned char>(text_[at]);
    const bool control = byte < 0x20u || byte == 0x7fu;
    if (!control && !(ascii && byte > 0x7eu)) return;
    fail({{}, at, false}, fmt::format("byte 0x{:02x} is not allowed here; words are made of printable ASCII", byte));
}

}  // namespace pelage::language
