// See words.hpp.
#include "language/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>

namespace pelage::language {

namespace {

constexpr std::size_t longest = 32;  // no word of the language is longer, so longer ones mean none of them

char lower(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

constexpr int edit = 4;  // cost of a letter inserted, deleted, replaced, or swapped with its neighbour

int replacement(char a, char b) { return a == b ? 0 : lower(a) == lower(b) ? 1 : edit; }

// Optimal string alignment distance.
int distance(std::string_view a, std::string_view b) {
    std::array<std::array<int, longest + 1>, longest + 1> d{};
    for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = edit * static_cast<int>(i);
    for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = edit * static_cast<int>(j);
    for (std::size_t i = 1; i <= a.size(); ++i) {
        for (std::size_t j = 1; j <= b.size(); ++j) {
            d[i][j] =
                std::min({d[i - 1][j] + edit, d[i][j - 1] + edit, d[i - 1][j - 1] + replacement(a[i - 1], b[j - 1])});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
                d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + edit);
            }
        }
    }
    return d[a.size()][b.size()];
}

}  // namespace

std::string listed(Words words) { return words.empty() ? "none" : fmt::format("{}", fmt::join(words, ", ")); }

std::string_view nearest(std::string_view found, Words words) {
    std::string_view best;
    if (found.empty() || found.size() > longest) return best;
    int smallest = 0;
    for (const std::string_view word : words) {
        if (word.size() > longest) continue;
        const int far = distance(found, word);
        const auto allowed = edit * static_cast<int>(std::max(found.size(), word.size())) / 3;
        if (far <= allowed && (best.empty() || far < smallest)) {
            best = word;
            smallest = far;
        }
    }
    return best;
}

std::string suggestion(std::string_view found, Words words) {
    const std::string_view word = nearest(found, words);
    return word.empty() ? "" : fmt::format("; did you mean '{}'?", word);
}

std::string shortened(std::string_view found) {
    constexpr std::size_t most = 40;
    if (found.size() <= most) return std::string(found);
    std::size_t end = most;
    while (end > 0 && (static_cast<unsigned char>(found[end]) & 0xc0u) == 0x80u) --end;  // whole characters of UTF-8
    return std::string(found.substr(0, end)) + "...";
}

}  // namespace pelage::language
