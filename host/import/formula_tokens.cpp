// See formula_tokens.hpp.
#include "import/formula_tokens.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <array>
#include <cctype>
#include <charconv>
#include <cmath>

namespace pelage::imports {

namespace {

constexpr std::size_t most_tokens = 100'000;
constexpr std::array<std::string_view, 18> long_signs{
    "<<=", ">>=", "<=", ">=", "==", "!=", "&&", "||", "+=", "-=", "*=", "/=", "++", "--", "%=", "->", "<<", ">>"};

bool is(char c, int (*test)(int)) { return test(static_cast<unsigned char>(c)) != 0; }
bool in_name(char c) { return is(c, std::isalnum) || c == '_'; }

class Splitter {
public:
    Splitter(std::string_view text, const FormulaSource& source)
        : text_(text), source_(source), line_(source.first_line) {}

    std::vector<FormulaToken> split() {
        while (skip_blanks(), at_ < text_.size()) {
            if (tokens_.size() == most_tokens) fail("the formula is too long");
            take();
        }
        tokens_.push_back({FormulaToken::Kind::end, {}, 0.0, line_});
        return std::move(tokens_);
    }

private:
    [[noreturn]] void fail(std::string_view what) const { throw Error(fmt::format("{}: {}", source_.at(line_), what)); }

    bool starts(std::string_view what) const { return text_.substr(at_).starts_with(what); }

    void skip_to(std::size_t end) {
        for (; at_ < end; ++at_) line_ += text_[at_] == '\n' && source_.first_line != 0 ? 1 : 0;
    }

    void skip_blanks() {
        while (at_ < text_.size()) {
            if (is(text_[at_], std::isspace)) {
                skip_to(at_ + 1);
            } else if (starts("//")) {
                skip_to(std::min(text_.find('\n', at_), text_.size()));
            } else if (starts("/*")) {
                const std::size_t end = text_.find("*/", at_ + 2);
                if (end == std::string_view::npos) fail("a comment is not closed");
                skip_to(end + 2);
            } else {
                return;
            }
        }
    }

    void take() {
        const char c = text_[at_];
        const bool digit_next = at_ + 1 < text_.size() && is(text_[at_ + 1], std::isdigit);
        if (is(c, std::isdigit) || (c == '.' && digit_next)) return take_number();
        if (is(c, std::isalpha) || c == '_') return take_name();
        for (const std::string_view sign : long_signs) {
            if (starts(sign)) return add(FormulaToken::Kind::sign, sign.size());
        }
        if (!is(c, std::isprint))
            fail(fmt::format("byte 0x{:02x} is no part of a formula", static_cast<unsigned char>(c)));
        add(FormulaToken::Kind::sign, 1);
    }

    void add(FormulaToken::Kind kind, std::size_t length, double value = 0.0) {
        tokens_.push_back({kind, text_.substr(at_, length), value, line_});
        at_ += length;
    }

    void take_name() {
        std::size_t end = at_;
        while (end < text_.size() && in_name(text_[end])) ++end;
        add(FormulaToken::Kind::name, end - at_);
    }

    void take_number() {
        double value = 0.0;
        const char* const first = text_.data() + at_;
        const auto [end, error] = std::from_chars(first, text_.data() + text_.size(), value);
        if (error != std::errc() || !std::isfinite(value)) fail("a number is too large or too small");
        std::size_t length = static_cast<std::size_t>(end - first);
        const std::size_t next = at_ + length;
        const bool suffix =
            next < text_.size() && std::string_view("fFhuULl").find(text_[next]) != std::string_view::npos;
        const bool alone = next + 1 >= text_.size() || !in_name(text_[next + 1]);
        add(FormulaToken::Kind::number, length, value);
        if (suffix && alone) ++at_;
    }

    std::string_view text_;
    const FormulaSource& source_;
    std::size_t at_ = 0;
    std::size_t line_;
    std::vector<FormulaToken> tokens_;
};

}  // namespace

std::string FormulaSource::at(std::size_t line) const {
    return first_line == 0 ? name : fmt::format("{}:{}", name, line);
}

std::vector<FormulaToken> formula_tokens(std::string_view text, const FormulaSource& source) {
    return Splitter(text, source).split();
}

}  // namespace pelage::imports
