// Quotients and square roots as pairs, from a first guess by the bits and steps of third order.
#pragma once

#include "reference/functions/numbers.hpp"

namespace pelage::reference::functions {

// 1 / d for d between 2^-60 and 2^60, by so many steps, each of which makes the error its cube.
template <class T>
T reciprocal_by(int steps, T d) {
    const Bits<T> guess = single<T> ? Bits<T>(0x7ef311c7) : Bits<T>(0x7fde6238da3c2118);
    T y = number_of<T>(guess - bits_of(d));
    for (int step = 0; step < steps; ++step) {
        const T e = std::fma(-d, y, T(1));
        y = std::fma(y, std::fma(e, e, e), y);
    }
    return y;
}

// To a few units of the last place.
template <class T>
T reciprocal(T d) {
    return reciprocal_by(3, d);
}

// The same with a step less where float needs none more.
template <class T>
T quick_reciprocal(T d) {
    return reciprocal_by(single<T> ? 2 : 3, d);
}

// n / d for positive d between 2^-60 and 2^60.
template <class T>
Pair<T> quotient(Pair<T> n, Pair<T> d) {
    const T y = reciprocal(d.high);
    const T high = n.high * y;
    const T rest = std::fma(-high, d.high, n.high);
    return {high, (std::fma(-high, d.low, rest) + n.low) * y};
}

// The square root of s between 2^-120 and 2^120, or 0.
template <class T>
Pair<T> root(Pair<T> s) {
    const Bits<T> guess = single<T> ? Bits<T>(0x5f3759df) : Bits<T>(0x5fe6eb50c7b537a9);
    T y = number_of<T>(guess - (bits_of(s.high) >> 1));
    for (int step = 0; step < 3; ++step) {
        const T e = std::fma(-(s.high * y), y, T(1));
        y = std::fma(y, e * std::fma(e, T(0.375), T(0.5)), y);
    }
    const T high = s.high * y;
    return {high, (std::fma(-high, high, s.high) + s.low) * (T(0.5) * y)};
}

}  // namespace pelage::reference::functions
