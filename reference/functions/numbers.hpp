// What elementary functions are made of: bits of numbers, powers of two, sums and products with their rounding errors.
// As kernels/functions/numbers.cl, which says what they may use.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <type_traits>

namespace pelage::reference::functions {

template <class T>
inline constexpr bool single = std::is_same_v<T, float>;

template <class T>
using Bits = std::conditional_t<single<T>, std::uint32_t, std::uint64_t>;

// A constant of either precision.
template <class T>
constexpr T pick(float of_single, double of_double) {
    if constexpr (single<T>) return of_single;
    return static_cast<T>(of_double);
}

template <class T>
inline constexpr Bits<T> sign_bit = Bits<T>{1} << (8 * sizeof(T) - 1);
template <class T>
inline constexpr int fraction_bits = single<T> ? 23 : 52;
template <class T>
inline constexpr T infinite = std::numeric_limits<T>::infinity();
template <class T>
inline constexpr T not_a_number = std::numeric_limits<T>::quiet_NaN();

template <class T>
Bits<T> bits_of(T x) {
    return std::bit_cast<Bits<T>>(x);
}

template <class T>
T number_of(Bits<T> bits) {
    return std::bit_cast<T>(bits);
}

// pi/2 in two parts, ln 2 in two of which the first has so few bits that an exponent times it is exact.
template <class T>
inline constexpr T half_pi = pick<T>(0x1.921fb6p+0f, 0x1.921fb54442d18p+0);
template <class T>
inline constexpr T half_pi_low = pick<T>(-0x1.777a5cp-25f, 0x1.1a62633145c07p-54);
template <class T>
inline constexpr T ln2_high = pick<T>(0x1.62e4p-1f, 0x1.62e42fefa3p-1);
template <class T>
inline constexpr T ln2_low = pick<T>(0x1.7f7d1cp-20f, 0x1.3de6af278ece6p-42);

// The bits of a whole number w, |w| < 2^21, plus this one are w + const: its lowest bits are those of w.
template <class T>
inline constexpr T whole_shift = pick<T>(0x1.8p+23f, 0x1.8p+52);

// The nearest whole number, for |x| < 2^21.
template <class T>
T nearest(T x) {
    return (x + whole_shift<T>)-whole_shift<T>;
}

template <class T>
Bits<T> whole_bits(T w) {
    return bits_of<T>(w + whole_shift<T>);
}

template <class T>
T size_of(T x) {
    return number_of<T>(bits_of(x) & ~sign_bit<T>);
}

template <class T>
Bits<T> sign_of(T x) {
    return bits_of(x) & sign_bit<T>;
}

template <class T>
T with_sign(T x, Bits<T> sign) {
    return number_of<T>(bits_of(x) ^ sign);
}

// Single precision takes subnormal numbers for 0 of their sign.
template <class T>
T flushed(T x) {
    if constexpr (single<T>) return size_of(x) < 0x1p-126f ? number_of<T>(sign_of(x)) : x;
    return x;
}

// c0 x^n + c1 x^(n-1) + ...
template <class T>
T polynomial(T x, std::initializer_list<T> coefficients) {
    auto c = coefficients.begin();
    T sum = *c;
    while (++c != coefficients.end()) sum = std::fma(sum, x, *c);
    return sum;
}

// r 2^k for r in [1/2, 2) and whole k, |k| < 250 (2000); in single precision 0 where that is subnormal.
template <class T>
T scaled(T r, T k) {
    const Bits<T> both = whole_bits(k) - bits_of(whole_shift<T>) + (single<T> ? 256 : 2048);
    const Bits<T> half = both >> 1;
    const T first = number_of<T>((half - 1) << fraction_bits<T>);
    const T second = number_of<T>((both - half - 1) << fraction_bits<T>);
    if constexpr (single<T>) {
        if (k + (r < T(1) ? T(-1) : T(0)) < T(-126)) return T(0);
    }
    return (r * first) * second;
}

// 2^k for whole k whose power is a normal number.
template <class T>
T power_of_two(T k) {
    return number_of<T>((whole_bits(k) << fraction_bits<T>)+bits_of(T(1)));
}

// A number in two parts: high + low, where low is at most about a rounding error of high.
template <class T>
struct Pair {
    T high, low;
};

template <class T>
Pair<T> sum(T a, T b) {
    const T high = a + b;
    const T t = high - a;
    return {high, (a - (high - t)) + (b - t)};
}

// The same for |a| >= |b|, or a = 0.
template <class T>
Pair<T> quick_sum(T a, T b) {
    const T high = a + b;
    return {high, b - (high - a)};
}

template <class T>
Pair<T> product(T a, T b) {
    const T high = a * b;
    return {high, std::fma(a, b, -high)};
}

}  // namespace pelage::reference::functions
