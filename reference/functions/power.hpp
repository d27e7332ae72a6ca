// Powers of e: W. Cody and W. Waite, Software Manual for the Elementary Functions (1980), reduction by multiples of
// ln 2.
#pragma once

#include "reference/functions/numbers.hpp"

namespace pelage::reference::functions {

// e^(x + low) = (1 + more) 2^exponent, with -0.3 < more < 0.42.
template <class T>
struct Power {
    Pair<T> more;
    T exponent;
};

// (e^r - 1 - r) / r^2, |r| < 0.3466: minimax.
template <class T>
T power_tail(T r) {
    if constexpr (single<T>)
        return polynomial<T>(
            r, {0x1.9a981p-13f, 0x1.6d5146p-10f, 0x1.1115b4p-7f, 0x1.5554e4p-5f, 0x1.555552p-3f, 0x1.0p-1f});
    else
        return polynomial<T>(
            r, {0x1.1eed10ba3ff62p-29, 0x1.af6e5bd233d8fp-26, 0x1.27e5339dbae4cp-22, 0x1.71ddee863632bp-19,
                0x1.a01a017d48c66p-16, 0x1.a01a01b43e1c9p-13, 0x1.6c16c16c1e5bdp-10, 0x1.111111110ea06p-7,
                0x1.5555555555544p-5, 0x1.555555555555cp-3, 0x1.0p-1});
}

// |x| < 174 (1400); |low| is at most about a rounding error of x.
template <class T>
Power<T> power(T x, T low) {
    const T k = nearest(x * pick<T>(0x1.715476p+0f, 0x1.71547652b82fep+0));
    const T near = std::fma(-k, ln2_high<T>, x);  // exact
    const T r = std::fma(-k, ln2_low<T>, near);
    const T rest = std::fma(-k, ln2_low<T>, near - r) + low;
    const T tail = (r * r) * power_tail(r);
    const T high = r + tail;
    return {{high, ((r - high) + tail) + std::fma(rest, high, rest)}, k};
}

// 1 + s for -0.3 < s < 0.42.
template <class T>
Pair<T> one_more(Pair<T> s) {
    const T high = T(1) + s.high;
    return {high, ((T(1) - high) + s.high) + s.low};
}

// x where |x| is less than a bound, else that bound with its sign: beyond, every power of e is 0 or infinite.
template <class T>
T not_steep(T x) {
    const T steep = pick<T>(106.0f, 750.0);
    const T raised = x < -steep ? -steep : x;
    return raised > steep ? steep : raised;
}

}  // namespace pelage::reference::functions
