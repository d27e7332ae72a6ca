// Cursor's first half: splitting a line into words.
#include "language/cursor.hpp"

#include <fmt/format.h>

namespace pelage::language {

namespace {

bool blank(char c) { return c == ' ' || c == '\t'; }

}  // namespace

Cursor::Cursor(std::string_view source, std::size_t line, std::string_view text,
               const std::vector<Parameter>& parameters)
    : Cursor(source, line, text, &parameters, 0, text.size(), false) {}

Cursor::Cursor(std::string_view source, std::size_t line, std::string_view text,
               const std::vector<Parameter>* parameters, std::size_t from, std::size_t to, bool commas)
    : source_(source), line_(line), text_(text), parameters_(parameters) {
    split(from, to, commas);
}

Cursor Cursor::inside(const Token& quoted) const {
    const std::size_t from = quoted.offset + 1;
    return {source_, line_, text_, parameters_, from, from + quoted.text.size(), true};
}

void Cursor::split(std::size_t from, std::size_t to, bool commas) {
    std::size_t at = from;
    std::size_t end = from;  // of the last word
    const auto comment = [&](std::size_t i) { return !commas && text_.substr(i, 2) == "//"; };
    while (at < to && !comment(at)) {
        if (blank(text_[at])) {
            ++at;
        } else if (text_[at] == '"') {
            at = end = split_quoted(at, to);
        } else if (commas && text_[at] == ',') {
            tokens_.push_back({text_.substr(at, 1), at, false});
            end = ++at;
        } else {
            const std::size_t first = at;
            for (; at < to && !blank(text_[at]) && text_[at] != '"' && !comment(at); ++at) {
                if (commas && text_[at] == ',') break;
                check_byte(at, true);
            }
            tokens_.push_back({text_.substr(first, at - first), first, false});
            end = at;
        }
    }
    tokens_.push_back({{}, end, false});
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
