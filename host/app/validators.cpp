// See validators.hpp.
#include "app/validators.hpp"

#include "language/words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

namespace pelage::app {

namespace {

struct Whole {
    bool negative = false;
    std::uint64_t size = 0;
};

template <class Number>
std::optional<Number> read_number(std::string_view text) {
    Number value{};
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (failure != std::errc{} || end != text.data() + text.size()) return {};
    return value;
}

std::optional<Whole> to_whole(std::string_view text) {
    if (text.starts_with('+')) text.remove_prefix(1);
    Whole whole{text.starts_with('-'), 0};
    if (whole.negative) text.remove_prefix(1);
    if (text.empty() || text[0] == '-' || text[0] == '+') return {};
    if (const auto digits = read_number<std::uint64_t>(text)) {
        whole.size = *digits;
        return whole;
    }
    constexpr double exact = 9007199254740992.0;  // 2^53: above it a double leaves whole numbers out
    const auto value = read_number<double>(text);
    if (!value || !std::isfinite(*value) || *value > exact || *value != std::floor(*value)) return {};
    whole.size = static_cast<std::uint64_t>(*value);
    return whole;
}

bool within(const Whole& whole, std::int64_t smallest, std::uint64_t largest) {
    if (!whole.negative || whole.size == 0)
        return whole.size <= largest && (smallest <= 0 || whole.size >= static_cast<std::uint64_t>(smallest));
    // The most negative number has no positive counterpart.
    return smallest < 0 && whole.size - 1 <= static_cast<std::uint64_t>(-(smallest + 1));
}

}  // namespace

CLI::Validator whole_number(std::int64_t smallest, std::uint64_t largest, std::uint64_t multiple_of) {
    const auto bring = [=](std::string& word) -> std::string {
        const std::optional<Whole> whole = to_whole(word);
        if (!whole || !within(*whole, smallest, largest) || whole->size % multiple_of != 0) {
            const std::string kind = multiple_of == 1 ? "whole number" : fmt::format("multiple of {}", multiple_of);
            return fmt::format("'{}' is not a {} from {} to {}", word, kind, smallest, largest);
        }
        word = fmt::format("{}{}", whole->negative && whole->size != 0 ? "-" : "", whole->size);
        return {};
    };
    return {bring, ""};
}

CLI::Validator one_of(const std::vector<std::string>& words) {
    const auto look = [words](std::string& word) -> std::string {
        if (std::ranges::find(words, word) != words.end()) return {};
        return fmt::format("'{}' is none of {}{}", word, fmt::join(words, ", "), meant(word, words));
    };
    return {look, ""};
}

CLI::Validator number(double least, double most) {
    const auto look = [least, most](std::string& word) -> std::string {
        const bool plus = word.size() > 1 && word[0] == '+' && word[1] != '-';
        const auto value = read_number<double>(std::string_view(word).substr(plus ? 1 : 0));
        if (value && *value >= least && *value <= most) return {};
        return fmt::format("'{}' is not a number from {} to {}", word, least, most);
    };
    return {look, ""};
}

std::string meant(const std::string& found, const std::vector<std::string>& words) {
    const std::vector<std::string_view> views(words.begin(), words.end());
    return language::suggestion(found, views);
}

CLI::Validator trimmed() {
    const auto trim = [](std::string& word) -> std::string {
        const std::size_t first = std::min(word.find_first_not_of(" \t"), word.size());
        word.erase(0, first);
        word.erase(word.find_last_not_of(" \t") + 1);
        return {};
    };
    return {trim, ""};
}

}  // namespace pelage::app
