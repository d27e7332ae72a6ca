// See numbers.hpp.
#include "mesh/numbers.hpp"

#include <charconv>
#include <system_error>

namespace pelage {

namespace {

constexpr std::string_view blanks = " \t\v\f";

template <class T>
std::optional<T> to_number(std::string_view word) {
    if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
    T value{};
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size()) return {};
    return value;
}

}  // namespace

std::string_view cut_line(std::string_view& text) {
    const std::size_t end = text.find_first_of("\r\n");
    const std::string_view line = text.substr(0, end);
    if (end == std::string_view::npos) {
        text = {};
    } else {
        text.remove_prefix(end + (text.substr(end, 2) == "\r\n" ? 2 : 1));
    }
    return line;
}

std::string_view next_word(std::string_view& line) {
    const std::size_t begin = line.find_first_not_of(blanks);
    if (begin == std::string_view::npos) {
        line = {};
        return {};
    }
    line.remove_prefix(begin);
    const std::string_view word = line.substr(0, line.find_first_of(blanks));
    line.remove_prefix(word.size());
    return word;
}

std::optional<double> to_double(std::string_view word) { return to_number<double>(word); }

std::optional<std::int64_t> to_integer(std::string_view word) { return to_number<std::int64_t>(word); }

std::string shown(std::string_view word) {
    constexpr std::size_t most = 40;
    std::string text = "'";
    for (const char c : word.substr(0, most)) text += c >= 32 && c < 127 ? c : '?';
    return text + (word.size() > most ? "...'" : "'");
}

}  // namespace pelage
