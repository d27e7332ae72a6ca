// The weight of a candidate: the share of the potentials' range that it has, to the power of eta. As
// kernels/aggregate/terms.cl, bit for bit: no operation here is a fused one.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace pelage::reference {

inline constexpr std::uint64_t full_weight = std::uint64_t{1} << 38;

// 1 / d, off by about a rounding error; d from 1 to 2^31.
inline float reciprocal(float d) {
    float y = std::bit_cast<float>(0x7ef311c3u - std::bit_cast<std::uint32_t>(d));
    for (int i = 0; i < 4; ++i) y = y * (2.0f - d * y);
    return y;
}

// Binary logarithm of normal x > 0: minimax for mantissas from sqrt(1/2) to sqrt(2), off by less than 2^-24 of it
// there.
inline float binary_log(float x) {
    const std::uint32_t bits = std::bit_cast<std::uint32_t>(x);
    const std::int32_t exponent = static_cast<std::int32_t>(bits - 0x3f3504f3u) >> 23;
    const float t = std::bit_cast<float>(bits - (static_cast<std::uint32_t>(exponent) << 23)) - 1.0f;
    float p = 0x1.01b6c6p-3f;
    p = p * t + -0x1.a87d02p-3f;
    p = p * t + 0x1.b9c91cp-3f;
    p = p * t + -0x1.e95be8p-3f;
    p = p * t + 0x1.26d384p-2f;
    p = p * t + -0x1.715c4ep-2f;
    p = p * t + 0x1.ec73d6p-2f;
    p = p * t + -0x1.71547p-1f;
    p = p * t + 0x1.715476p+0f;
    return p * t + static_cast<float>(exponent);
}

// 2^y for -60 <= y <= 1: minimax between -1/2 and 1/2, off by less than 2^-22 of it.
inline float binary_power(float y) {
    const float shifted = y + 0x1.8p+23f;  // its lowest bits are the nearest whole number
    const float f = y - (shifted - 0x1.8p+23f);
    float p = 0x1.5c08e4p-10f;
    p = p * f + 0x1.3d0c52p-7f;
    p = p * f + 0x1.c6b6e4p-5f;
    p = p * f + 0x1.ebf918p-3f;
    p = p * f + 0x1.62e428p-1f;
    p = p * f + 0x1.000002p+0f;
    return std::bit_cast<float>(std::bit_cast<std::uint32_t>(p) + (std::bit_cast<std::uint32_t>(shifted) << 23));
}

// The values of candidates lie from `lowest` to `highest`.
class Weights {
public:
    Weights(std::int64_t lowest, std::int64_t highest, float eta)
        : lowest_(lowest), eta_(eta), flat_(lowest == highest || eta == 0.0f) {
        const auto range = static_cast<std::uint64_t>(highest) - static_cast<std::uint64_t>(lowest);
        down_ = std::max(0, static_cast<int>(std::bit_width(range)) - 31);
        if (!flat_) scale_ = reciprocal(static_cast<float>(static_cast<std::int32_t>(range >> down_)));
    }

    // The lowest has none, unless all have the same.
    std::uint64_t operator()(std::int64_t value) const {
        if (flat_) return full_weight;
        const auto above = static_cast<std::int32_t>(static_cast<std::uint64_t>(value - lowest_) >> down_);
        const float power = eta_ * binary_log(static_cast<float>(above) * scale_);
        const float held = power < -60.0f ? -60.0f : power;
        return above == 0 ? 0 : static_cast<std::uint64_t>(binary_power(held) * 0x1p38f);
    }

    // The same scale, counted from another lowest value.
    Weights from(std::int64_t lowest) const {
        Weights moved = *this;
        moved.lowest_ = lowest;
        return moved;
    }

private:
    std::int64_t lowest_;
    float eta_;
    bool flat_;
    int down_ = 0;
    float scale_ = 0.0f;
};

// The upper half of a product of 128 bits.
inline std::uint64_t upper_product(std::uint64_t a, std::uint64_t b) {
    const std::uint64_t low = 0xffffffffu;
    const std::uint64_t cross = (a >> 32) * (b & low) + ((a & low) * (b & low) >> 32);
    const std::uint64_t other = (a & low) * (b >> 32) + (cross & low);
    return (a >> 32) * (b >> 32) + (cross >> 32) + (other >> 32);
}

}  // namespace pelage::reference
