// See philox.hpp.
#include "core/philox.hpp"

namespace pelage {

std::array<std::uint32_t, 4> philox4x32_10(std::array<std::uint32_t, 4> counter, std::array<std::uint32_t, 2> key) {
    for (int round = 0; round < 10; ++round) {
        const std::uint64_t left = std::uint64_t{0xD2511F53u} * counter[0];
        const std::uint64_t right = std::uint64_t{0xCD9E8D57u} * counter[2];
        const auto high = [](std::uint64_t product) { return static_cast<std::uint32_t>(product >> 32); };
        const auto low = [](std::uint64_t product) { return static_cast<std::uint32_t>(product); };
        counter = {high(right) ^ counter[1] ^ key[0], low(right), high(left) ^ counter[3] ^ key[1], low(left)};
        key[0] += 0x9E3779B9u;  // golden ratio
        key[1] += 0xBB67AE85u;  // sqrt(3) - 1
    }
    return counter;
}

std::array<std::uint32_t, 4> counted_words(std::size_t cell, std::uint64_t iteration, std::size_t rule,
                                           std::uint32_t purpose, std::int64_t seed) {
    const auto key = static_cast<std::uint64_t>(seed);
    return philox4x32_10({static_cast<std::uint32_t>(cell), static_cast<std::uint32_t>(iteration),
                          static_cast<std::uint32_t>(rule), purpose},
                         {static_cast<std::uint32_t>(key), static_cast<std::uint32_t>(key >> 32)});
}

}  // namespace pelage
