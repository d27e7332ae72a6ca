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

// The upper half of a product.
inline std::uint64_t upper_product(std::uint64_t a, std::uint64_t b) {
    constexpr std::uint64_t lower_half = 0xffffffff;
    const std::uint64_t low = (a & lower_half) * (b & lower_half);
    const std::uint64_t one = (a >> 32) * (b & lower_half) + (low >> 32);
    const std::uint64_t other = (a & lower_half) * (b >> 32) + (one & lower_half);
    return (a >> 32) * (b >> 32) + (one >> 32) + (other >> 32);
}

// 64 bits of it from bit `first` on.
inline std::uint64_t turn_bits(std::size_t first) {
    const std::size_t at = first / 64;
    const std::uint64_t shift = std::uint64_t{1} << (first % 64);
    return two_over_pi[at] * shift + upper_product(two_over_pi[at + 1], shift);
}

// f0 2^-62 + f1 2^-126 in two parts, cut into numbers of as many bits as T has.
template <class T>
Pair<T> far_parts(std::uint64_t f0, std::uint64_t f1) {
    T first, second, third, fourth = T(0);
    if constexpr (single<T>) {
        first = static_cast<T>(f0 >> 38) * 0x1p-24f;
        second = static_cast<T>(f0 >> 14 & 0xffffff) * 0x1p-48f;
        third = static_cast<T>(f0 & 0x3fff) * 0x1p-62f;
    } else {
        first = static_cast<T>(f0 >> 9) * 0x1p-53;
        second = static_cast<T>(f0 & 0x1ff) * 0x1p-62;
        third = static_cast<T>(f1 >> 11) * 0x1p-115;
        fourth = static_cast<T>(f1 & 0x7ff) * 0x1p-126;
    }
    const Pair<T> upper = quick_sum(first, second);
    Pair<T> all = quick_sum(upper.high, upper.low + third);
    all.low += fourth;
    return all;
}

// size = (quarters + high + low) pi/2, less multiples of 2 pi.
template <class T>
struct FarTurn {
    Pair<T> share;  // between -1/2 and 1/2
    T quarters;     // from 0 to 4
};

// For finite size > 1.
template <class T>
FarTurn<T> far_turn(T size) {
    const Bits<T> bits = bits_of(size);
    const int exponent = static_cast<int>(bits >> fraction_bits<T>) - (single<T> ? 127 : 1023);
    const auto first = static_cast<std::size_t>(exponent - fraction_bits<T> + 62);
    const std::uint64_t hidden = std::uint64_t{1} << fraction_bits<T>;
    const std::uint64_t m = (bits & (hidden - 1)) | hidden;
    // 128 bits of the product; the first two of them are the quarters.
    const std::uint64_t middle = turn_bits(first + 64);
    const std::uint64_t carried = upper_product(m, turn_bits(first + 128));
    const std::uint64_t p1 = m * middle + carried;
    const std::uint64_t p0 = m * turn_bits(first) + upper_product(m, middle) + (p1 < carried ? 1 : 0);
    const bool more = (p0 >> 61 & 1) != 0;  // than half a quarter: count from the next one
    constexpr std::uint64_t fraction = 0x3fffffffffffffff;
    const Pair<T> share = far_parts<T>((more ? ~p0 : p0) & fraction, more ? ~p1 : p1);
    const Bits<T> sign = more ? sign_bit<T> : Bits<T>{0};
    return {{with_sign(share.high, sign), with_sign(share.low, sign)}, static_cast<T>((p0 >> 62) + (more ? 1 : 0))};
}

}  // namespace pelage::reference::functions
