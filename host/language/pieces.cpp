// See pieces.hpp.
#include "language/pieces.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>

namespace pelage::language {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool starts_name(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }
bool in_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

bool names_word(std::string_view text, std::string_view name) {
    const auto part = [&](std::size_t at) { return at < text.size() && in_name(text[at]); };
    for (std::size_t at = text.find(name); at != std::string_view::npos; at = text.find(name, at + 1)) {
        if ((at == 0 || !part(at - 1)) && !part(at + name.size())) return true;
    }
    return false;
}

Pieces::Pieces(const Cursor& cursor, const Token& expression, const Names& names)
    : cursor_(cursor), text_(expression.text), offset_(expression.offset), names_(names) {
    advance();
}

bool Pieces::take(std::string_view wanted) {
    if (now_.text != wanted) return false;
    advance();
    return true;
}

Token Pieces::next() {
    const Token token = now_;
    advance();
    return token;
}

void Pieces::advance() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
    const std::size_t first = at_;
    if (at_ < text_.size()) at_ += length(text_.substr(at_));
    now_ = {text_.substr(first, at_ - first), offset_ + first, false};
}

namespace {

std::size_t number_length(std::string_view rest) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), value);
    return std::max<std::size_t>(1, static_cast<std::size_t>(end - rest.data()));
}

}  // namespace

std::size_t Pieces::length(std::string_view rest) const {
    if (is_digit(rest[0]) || (rest[0] == '.' && rest.size() > 1 && is_digit(rest[1]))) return number_length(rest);
    if (starts_name(rest[0])) return name_length(rest);
    for (const std::string_view two : {"==", "!=", "<=", ">=", "&&", "||", "**"}) {
        if (rest.starts_with(two)) return 2;
    }
    return 1;
}

// A name may have a minus in it: the longest one that is known is meant.
std::size_t Pieces::name_length(std::string_view rest) const {
    std::size_t end = 0;
    while (end < rest.size() && in_name(rest[end])) ++end;
    std::size_t best = end;
    for (std::size_t more = end; more < rest.size() && (in_name(rest[more]) || rest[more] == '-'); ++more) {
        const bool ends = more + 1 == rest.size() || !in_name(rest[more + 1]);
        if (ends && names_.find({rest.substr(0, more + 1), 0, false})) best = more + 1;
    }
    return best;
}

}  // namespace pelage::language
