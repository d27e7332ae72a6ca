// Far angles: M. Payne and R. Hanek, "Radian reduction for trigonometric functions" (SIGNUM Newsletter, 1983), in whole
// numbers. An angle is m 2^e with whole m; of 2/pi only those 192 bits count that, times m 2^e, are no multiples of 4
// and no less than any angle needs.
#pragma once

#include "reference/functions/numbers.hpp"

#include <array>
#include <cstddef>

namespace pelage::reference::functions {

// 64 bits of 0, and the bits of 2/pi after its point.
inline constexpr std::array<std::uint64_t, 20> two_over_pi{
    0x0000000000000000, 0xa2f9836e4e441529, 0xfc2757d1f534ddc0, 0xdb6295993c439041, 0xfe5163abdebbc561,
    0xb7246e3a424dd2e0, 0x06492eea09d1921c, 0xfe1deb1cb129a73e, 0xe88235f52ebb4484, 0xe99c7026b45f7e41,
    0x3991d639835339f4, 0x9c845f8bbdf9283b, 0x1ff897ffde05980f, 0xef2f118b5a0a6d1f, 0x6d367ecf27cb09b7,
    0x4f463f669e5fea2d, 0x7527bac7ebe5f17b, 0x3d0739f78a5292ea, 0x6bfb5fb11f8d5d08, 0x56033046fc7b6bab};

// 64 bits of it from bit `first` on.
inline std::uint64_t turn_bits(std::size_t first) {
    const std::size_t at = first / 64;
    const std::size_t within = first % 64;
    const std::uint64_t high = two_over_pi[at] << within;
    return within == 0 ? high : high | two_over_pi[at + 1] >> (64 - within);
}

// The upper half of a product.
inline std::uint64_t upper_product(std::uint64_t a, std::uint64_t b) {
    constexpr std::uint64_t lower_half = 0xffffffff;
    const std::uint64_t low = (a & lower_half) * (b & lower_half);
    const std::uint64_t one = (a >> 32) * (b & lower_half) + (low >> 32);
    const std::uint64_t other = (a & lower_half) * (b >> 32) + (one & lower_half);
    return (a >> 32) * (b >> 32) + (one >> 32) + (other >> 32);
}

// size = (quarters + high + low) pi/2, less multiples of 2 pi.
template <class T>
struct FarTurn {
    T high, low;  // high is between -1/2 and 1/2, low is the bits that follow its own
    T quarters;   // from 0 to 4
};

// For finite size > 1.
template <class T>
FarTurn<T> far_turn(T size) {
    constexpr int own_bits = fraction_bits<T> + 1;
    const Bits<T> bits = bits_of(size);
    const int exponent = static_cast<int>(bits >> fraction_bits<T>) - (single<T> ? 127 : 1023);
    const auto first = static_cast<std::size_t>(exponent - fraction_bits<T> + 62);
    const std::uint64_t hidden = std::uint64_t{1} << fraction_bits<T>;
    const std::uint64_t m = (bits & (hidden - 1)) | hidden;
    // The lowest 192 bits of the product; the first two of them are the quarters.
    const std::uint64_t middle = turn_bits(first + 64);
    const std::uint64_t last = turn_bits(first + 128);
    const std::uint64_t p1 = m * middle + upper_product(m, last);
    const std::uint64_t carry = p1 < upper_product(m, last) ? 1 : 0;
    const std::uint64_t p0 = m * turn_bits(first) + upper_product(m, middle) + carry;
    std::uint64_t f0 = p0 << 2 | p1 >> 62;
    std::uint64_t f1 = p1 << 2 | (m * last) >> 62;
    const bool more = f0 >> 63 != 0;  // than half a quarter: count from the next one
    if (more) {
        f0 = ~f0;
        f1 = ~f1;
    }
    const int zeros = std::countl_zero(f0);
    if (zeros != 0) f0 = f0 << zeros | f1 >> (64 - zeros);
    f1 <<= zeros;
    const std::uint64_t after = single<T> ? f0 >> 16 & 0xffffff : (f0 << 42 | f1 >> 22) & 0x1fffffffffffff;
    const T unit = power_of_two(static_cast<T>(-(zeros + own_bits)));
    const T sign = more ? -unit : unit;
    return {static_cast<T>(f0 >> (64 - own_bits)) * sign,
            static_cast<T>(after) * (sign * power_of_two(static_cast<T>(-own_bits))),
            static_cast<T>((p0 >> 62) + (more ? 1 : 0))};
}

}  // namespace pelage::reference::functions
