// See cursor.hpp.
#include "language/cursor.hpp"

#include "language/expression.hpp"
#include "language/pieces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace pelage::language {

namespace {

std::string_view without_plus(std::string_view text) {
    const bool plus = text.size() > 1 && text[0] == '+' && text[1] != '-' && text[1] != '+';
    return plus ? text.substr(1) : text;
}

template <class Integer>
std::optional<Integer> to_integer(std::string_view text) {
    text = without_plus(text);
    Integer value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return value;
}

bool whole(std::string_view text) {
    text = without_plus(text);
    if (!text.empty() && text[0] == '-') text.remove_prefix(1);
    return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

// Why to_number() refuses a text.
std::string_view number_fault(std::string_view text) {
    text = without_plus(text);
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (text.empty() || error == std::errc::invalid_argument || end != text.data() + text.size())
        return "is not a number";
    const bool finite = error == std::errc::result_out_of_range || std::isfinite(value);
    return finite ? "is beyond what a float can hold" : "is not finite";
}

std::string kind_of(const Range& range) {
    const bool low = std::isfinite(range.low);
    const bool high = std::isfinite(range.high);
    if (low && range.above && high) return fmt::format("a number above {}, at most {}", range.low, range.high);
    if (low && range.above) return fmt::format("a number above {}", range.low);
    if (low && high) return fmt::format("a number from {} to {}", range.low, range.high);
    if (low) return fmt::format("a number not below {}", range.low);
    return "a number";
}

}  // namespace

namespace {

// Where a number must be known while the file is being read.
class ConstantNames final : public Names {
public:
    explicit ConstantNames(const std::vector<Parameter>& parameters) : parameters_(parameters) {}

    std::optional<Operand> find(const Token& at) const override {
        const auto found = std::ranges::find(parameters_, at.text, &Parameter::name);
        if (found == parameters_.end()) return std::nullopt;
        return Operand::number(found->value);
    }
    std::optional<Operand> of_chemical(const Token&, const Token&) const override { return std::nullopt; }
    bool takes_chemical(std::string_view) const override { return false; }
    std::vector<std::string_view> chemical_words() const override { return {}; }
    std::vector<std::string_view> all() const override {
        std::vector<std::string_view> names;
        for (const Parameter& one : parameters_) names.push_back(one.name);
        return names;
    }

private:
    const std::vector<Parameter>& parameters_;
};

}  // namespace

Error error_at(const Experiment& experiment, Place place, std::string_view text) {
    return Error(fmt::format("{}:{}: {}", experiment.where(place.line), place.column, text));
}

std::optional<double> to_number(std::string_view text) {
    text = without_plus(text);
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    if (!std::isfinite(value) || std::fabs(value) > static_cast<double>(std::numeric_limits<float>::max())) {
        return std::nullopt;
    }
    return value;
}

bool Cursor::take(std::string_view word) {
    if (peek().quoted || peek().text != word || done()) return false;
    ++next_;
    return true;
}

const Token& Cursor::next() {
    const Token& token = peek();
    if (!done()) ++next_;
    return token;
}

void Cursor::expect(std::string_view word) {
    if (!take(word)) unknown(peek(), {&word, 1});
}

std::size_t Cursor::choose(Words allowed) {
    for (std::size_t i = 0; i < allowed.size(); ++i) {
        if (take(allowed[i])) return i;
    }
    unknown(peek(), allowed);
}

void Cursor::finish() const {
    if (!done()) fail(peek(), fmt::format("{} follows a statement that is complete", shown(peek())));
}

const Token& Cursor::value(std::string_view what) {
    if (done() || peek().quoted) needs(peek(), "has quotes", what, "a word without quotes");
    return next();
}

const Parameter* Cursor::parameter(const Token& token) const {
    if (token.quoted) return nullptr;
    const auto found = std::ranges::find(*parameters_, token.text, &Parameter::name);
    return found == parameters_->end() ? nullptr : &*found;
}

// The value of a parameter or an expression.
std::optional<double> Cursor::computed_here() const {
    if (const Parameter* named = parameter(peek())) return named->value;
    if (!is_expression(peek())) return std::nullopt;
    return read_expression(*this, peek(), ConstantNames(*parameters_)).nodes.back().operand.value;
}

std::optional<double> Cursor::number_here() const {
    if (const auto computed = computed_here()) return computed;
    return peek().quoted ? std::nullopt : to_number(peek().text);
}

double Cursor::number(std::string_view what, Range range) {
    const std::string kind = kind_of(range);
    const std::optional<double> value = number_here();
    if (!value) needs(peek(), peek().quoted ? "is not a number" : number_fault(peek().text), what, kind);
    if (*value < range.low || *value > range.high || (range.above && *value == range.low)) {
        needs(peek(), "is out of range", what, kind);
    }
    if (range.above && static_cast<double>(static_cast<float>(*value)) <= range.low) {
        needs(peek(), fmt::format("is {} in float", range.low), what, kind);
    }
    next();
    return *value;
}

void Cursor::note_whole() const {
    for (const Parameter& one : *parameters_) {
        if (is_expression(peek()) ? names_word(peek().text, one.name) : peek().text == one.name) one.whole = true;
    }
}

// Empty where it does not fit the type.
template <class Integer>
std::optional<Integer> Cursor::integer_here(std::string_view what, std::string_view kind) const {
    if (const auto computed = computed_here()) {
        note_whole();
        if (std::floor(*computed) != *computed) needs(peek(), "is not a whole number", what, kind);
        if (std::fabs(*computed) >= largest_whole) needs(peek(), "is too large to be exact", what, kind);
        return to_integer<Integer>(fmt::format("{:.0f}", *computed));
    }
    if (peek().quoted || !whole(peek().text)) needs(peek(), "is not a whole number", what, kind);
    return to_integer<Integer>(peek().text);
}

std::uint64_t Cursor::integer(std::string_view what, std::uint64_t low, std::uint64_t high) {
    const std::string kind = fmt::format("a whole number from {} to {}", low, high);
    const auto value = integer_here<std::uint64_t>(what, kind);
    if (!value || *value < low || *value > high) needs(peek(), "is out of range", what, kind);
    next();
    return *value;
}

std::int64_t Cursor::signed_integer(std::string_view what) {
    const auto value = integer_here<std::int64_t>(what, "a whole number");
    if (!value) needs(peek(), "is out of range", what, "a whole number of 64 bits");
    next();
    return *value;
}

const Token& Cursor::text(std::string_view what) {
    if (!peek().quoted) needs(peek(), "has no quotes", what, "a text in double quotes");
    if (peek().text.empty()) needs(peek(), "is empty", what, "a text in double quotes");
    return next();
}

void Cursor::fail(const Token& at, std::string_view text) const {
    throw Error(fmt::format("{}:{}: {}", where_, place(at).column, text));
}

void Cursor::unknown(const Token& at, Words allowed, std::string_view end) const {
    const std::string list = listed(allowed) + std::string(end);
    if (&at == &tokens_.back()) fail(at, fmt::format("the line ends too early; allowed here: {}", list));
    const std::string meant = at.quoted ? "" : suggestion(at.text, allowed);
    fail(at, fmt::format("unknown word {}; allowed here: {}{}", shown(at), list, meant));
}

void Cursor::needs(const Token& at, std::string_view found, std::string_view what, std::string_view kind) const {
    if (&at == &tokens_.back()) fail(at, fmt::format("the line ends too early; {} must be {}", what, kind));
    fail(at, fmt::format("{} {}; {} must be {}{}", described(at), found, what, kind, meant(at)));
}

// With the value of a parameter.
std::string Cursor::described(const Token& token) const {
    if (is_expression(token)) {
        const double value = read_expression(*this, token, ConstantNames(*parameters_)).nodes.back().operand.value;
        return fmt::format("expression {} is {}, which", shown(token), value);
    }
    const Parameter* named = parameter(token);
    if (named == nullptr) return shown(token);
    return fmt::format("parameter {} of line {} is {}, which", shown(token), named->line, named->value);
}

// The parameter that a mistyped word may mean.
std::string Cursor::meant(const Token& token) const {
    if (token.quoted || parameter(token) != nullptr || to_number(token.text)) return "";
    std::vector<std::string_view> names;
    for (const Parameter& one : *parameters_) names.push_back(one.name);
    return suggestion(token.text, names);
}

Place Cursor::place(const Token& token) const {
    const std::string_view before = text_.substr(0, token.offset);
    const auto continues = [](char c) { return (static_cast<unsigned char>(c) & 0xc0u) == 0x80u; };
    const auto hidden = std::count_if(before.begin(), before.end(), continues);
    return {line_, before.size() - static_cast<std::size_t>(hidden) + 1};
}

std::string Cursor::shown(const Token& token) {
    const char quote = token.quoted ? '"' : '\'';
    return fmt::format("{}{}{}", quote, shortened(token.text), quote);
}

std::optional<std::size_t> Options::next(Cursor& cursor) {
    if (cursor.done()) return std::nullopt;
    if (const auto index = next_if(cursor)) return index;
    std::vector<std::string_view> left;
    for (std::size_t i = 0; i < words_.size(); ++i) {
        if (!given(i)) left.push_back(words_[i]);
    }
    cursor.unknown(cursor.peek(), left, left.empty() ? ", the end of the line" : ", or the end of the line");
}

std::optional<std::size_t> Options::next_if(Cursor& cursor) {
    const Token& token = cursor.peek();
    for (std::size_t i = 0; i < words_.size(); ++i) {
        if (!cursor.take(words_[i])) continue;
        if (given(i)) cursor.fail(token, fmt::format("'{}' is given twice", words_[i]));
        given_ |= 1u << i;
        return i;
    }
    return std::nullopt;
}

}  // namespace pelage::language
