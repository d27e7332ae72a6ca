// See base64.hpp.
#include "import/base64.hpp"

#include <array>
#include <cstdint>

namespace pelage::imports {

namespace {

constexpr std::string_view digits_of_base64 = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr int blank_byte = -1, padding_byte = -2, no_digit = -3;

constexpr std::array<std::int8_t, 256> table_of_base64() {
    std::array<std::int8_t, 256> table{};
    table.fill(no_digit);
    for (const char c : {' ', '\n', '\r', '\t'}) table[static_cast<unsigned char>(c)] = blank_byte;
    table['='] = padding_byte;
    for (std::size_t i = 0; i < digits_of_base64.size(); ++i)
        table[static_cast<unsigned char>(digits_of_base64[i])] = static_cast<std::int8_t>(i);
    return table;
}

constexpr auto digit_table = table_of_base64();

}  // namespace

std::optional<std::string> from_base64(std::string_view text, std::size_t most) {
    std::string bytes;
    std::uint32_t group = 0;
    int digits = 0, padding = 0;
    for (const char c : text) {
        if (bytes.size() >= most) break;
        const int digit = digit_table[static_cast<unsigned char>(c)];
        if (digit == blank_byte) continue;
        if (digit == no_digit || (padding > 0 && digit != padding_byte)) return std::nullopt;
        padding += digit == padding_byte ? 1 : 0;
        group = group << 6 | static_cast<std::uint32_t>(digit == padding_byte ? 0 : digit);
        if (++digits < 4) continue;
        if (padding > 2) return std::nullopt;
        for (int i = 0; i < 3 - padding; ++i) bytes += static_cast<char>(group >> (16 - 8 * i) & 0xffu);
        group = 0;
        digits = padding = 0;
    }
    if (bytes.size() < most && digits != 0) return std::nullopt;
    if (bytes.size() > most) bytes.resize(most);
    return bytes;
}

}  // namespace pelage::imports
