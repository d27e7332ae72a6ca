// See utf8.hpp.
#include "io/utf8.hpp"

#include <cstddef>

namespace pelage {
namespace {

constexpr std::string_view replacement_character = "\xef\xbf\xbd";

bool within(std::string_view text, std::size_t at, unsigned low, unsigned high) {
    if (at >= text.size()) return false;
    const auto byte = static_cast<unsigned char>(text[at]);
    return byte >= low && byte <= high;
}

// Bytes of the character at the text's beginning; 0: there is none. The second byte's bounds leave out forms that are
// longer than need be, halves of surrogate pairs, and numbers beyond U+10FFFF.
std::size_t character_length(std::string_view text) {
    const auto first = static_cast<unsigned char>(text[0]);
    if (first < 0x80) return 1;
    if (first < 0xc2 || first > 0xf4) return 0;
    const std::size_t length = first < 0xe0 ? 2 : first < 0xf0 ? 3 : 4;
    const unsigned low = first == 0xe0 ? 0xa0 : first == 0xf0 ? 0x90 : 0x80;
    const unsigned high = first == 0xed ? 0x9f : first == 0xf4 ? 0x8f : 0xbf;
    if (!within(text, 1, low, high)) return 0;
    for (std::size_t i = 2; i < length; ++i) {
        if (!within(text, i, 0x80, 0xbf)) return 0;
    }
    return length;
}

}  // namespace

std::string valid_utf8(std::string_view text) {
    std::string result;
    result.reserve(text.size());
    while (!text.empty()) {
        const auto length = character_length(text);
        result += length == 0 ? replacement_character : text.substr(0, length);
        text.remove_prefix(length == 0 ? 1 : length);
    }
    return result;
}

}  // namespace pelage
