// x^y as e^(y ln x), with ln x to half as many bits again as a number has. Special values are those of C (annex F).
#pragma once

#include "reference/functions/logarithm.hpp"
#include "reference/functions/power.hpp"
#include "reference/functions/quotient.hpp"

namespace pelage::reference::functions {

// With s = (m - 1) / (m + 1), ln m = 2 s + s^3 (2/3 + ...): (ln m - 2 s - 2/3 s^3) / s^5 of z = s^2, for m from
// sqrt(1/2) to sqrt(2), minimax.
template <class T>
T pow_tail(T z) {
    if constexpr (single<T>)
        return polynomial<T>(z, {0x1.dfa3b4p-3f, 0x1.245278p-2f, 0x1.999ap-2f});
    else
        return polynomial<T>(z,
                             {0x1.eacd52ec57d83p-4, 0x1.de3ca9d11d6p-4, 0x1.11207325d4d45p-3, 0x1.3b1364b59a6a1p-3,
                              0x1.745d182985acfp-3, 0x1.c71c71c596643p-3, 0x1.2492492492f51p-2, 0x1.9999999999996p-2});
}

// ln x of positive x.
template <class T>
Pair<T> long_log(T x) {
    const Parts<T> parts = parts_around_one(x);
    const Pair<T> s = quotient(Pair<T>{parts.mantissa - T(1), T(0)}, sum(parts.mantissa, T(1)));
    Pair<T> z = product(s.high, s.high);
    z.low = std::fma(T(2) * s.high, s.low, z.low);
    // w = 2/3 + z tail, v = z w, t = s v
    Pair<T> w = quick_sum(pick<T>(0x1.555556p-1f, 0x1.5555555555555p-1), z.high * pow_tail(z.high));
    w.low += pick<T>(-0x1.555556p-26f, 0x1.5555555555555p-55);
    Pair<T> v = product(z.high, w.high);
    v.low += std::fma(z.high, w.low, z.low * w.high);
    Pair<T> t = product(s.high, v.high);
    t.low += std::fma(s.high, v.low, s.low * v.high);
    const Pair<T> twice = quick_sum(T(2) * s.high, t.high);
    const Pair<T> all = quick_sum(parts.exponent * ln2_high<T>, twice.high);
    const T low = std::fma(T(2), s.low, t.low) + twice.low;
    return quick_sum(all.high, all.low + std::fma(parts.exponent, ln2_low<T>, low));
}

// |x|^y of |x| and y that are no NaN; |x| may be 0 or infinite, and so may y.
template <class T>
T pow_size(T size, T y) {
    const bool ends = size == T(0) || size == infinite<T>;
    const Pair<T> log = ends ? Pair<T>{size == T(0) ? -infinite<T> : infinite<T>, T(0)} : long_log(size);
    Pair<T> p = product(y, log.high);
    p.low = std::fma(y, log.low, p.low);
    const T bound = pick<T>(150.0f, 1100.0);
    const bool within = size_of(p.high) < bound;
    const T raised = p.high < -bound ? -bound : p.high;
    const Power<T> found = power(raised > bound ? bound : raised, within && !ends ? p.low : T(0));
    const Pair<T> value = one_more(found.more);
    return scaled(value.high + value.low, found.exponent);
}

template <class T>
T pow(T x, T y) {
    x = flushed(x);
    y = flushed(y);
    const T size = size_of(x);
    if (x == T(1) || y == T(0) || (x == T(-1) && size_of(y) == infinite<T>)) return T(1);
    if (std::isnan(x) || std::isnan(y)) return x + y;
    const bool whole = std::rint(y) == y;
    if (x < T(0) && size < infinite<T> && !whole) return not_a_number<T>;
    const bool odd = whole && std::rint(T(0.5) * y) != T(0.5) * y;
    return with_sign(pow_size(size, y), odd ? sign_of(x) : Bits<T>{0});
}

}  // namespace pelage::reference::functions
