// Random numbers of a training: counted, so that each depends on the seed and on what it is for alone.
#pragma once

#include "core/philox.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace pelage::learn {

// What a draw is for. Apart from those of core/philox.hpp.
enum class Draw : std::uint32_t { weights = 0x100, directions, places, iterations };

inline std::array<std::uint32_t, 4> drawn(std::int64_t seed, Draw draw, std::size_t which, std::uint64_t when) {
    return counted_words(which, when, 0, static_cast<std::uint32_t>(draw), seed);
}

// Evenly from -1 to 1.
inline double around_zero(std::int64_t seed, Draw draw, std::size_t which) {
    return 2 * unit_uniform<double>(drawn(seed, draw, which / 4, 0)[which % 4]) - 1;
}

// Evenly from 0 to count - 1.
inline std::size_t one_of(std::uint32_t word, std::size_t count) {
    return static_cast<std::size_t>((std::uint64_t{word} * count) >> 32);
}

}  // namespace pelage::learn
