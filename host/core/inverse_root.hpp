// What a charge adds to a potential: the inverse of a distance, with the same bits on every backend
// (kernels/aggregate/terms.cl). No operation here is a fused one.
#pragma once

#include <bit>
#include <cstdint>

namespace pelage {

// 1 / sqrt(d) for 1 <= d < 2^31, off by less than 2^-22 of it: a guess from the bits, and three of Newton's steps.
inline float inverse_root(float d) {
    const float half = 0.5f * d;
    float y = std::bit_cast<float>(0x5f375a86u - (std::bit_cast<std::uint32_t>(d) >> 1));
    y = y * (1.5f - (half * y) * y);
    y = y * (1.5f - (half * y) * y);
    return y * (1.5f - (half * y) * y);
}

// size * 2^30 / r, rounded to a whole number, for a distance whose square is given.
inline std::int64_t inverse_parts_at(float square, float size) {
    const float parts = inverse_root(square) * 0x1p30f * size;
    // Beyond there are whole numbers alone.
    return static_cast<std::int64_t>(parts < 0x1p23f ? (parts + 0x1p23f) - 0x1p23f : parts);
}

// That of two different sites.
inline std::int64_t inverse_distance(std::uint32_t one, std::uint32_t other, std::uint32_t columns, float size = 1.0f) {
    const auto x = static_cast<std::int32_t>(one % columns) - static_cast<std::int32_t>(other % columns);
    const auto y = static_cast<std::int32_t>(one / columns) - static_cast<std::int32_t>(other / columns);
    return inverse_parts_at(static_cast<float>(x * x + y * y), size);
}

}  // namespace pelage
