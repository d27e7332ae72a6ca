// The hyperbolic sine.
#pragma once

#include "reference/functions/steep.hpp"

namespace pelage::reference::functions {

// (sinh(x) - x) / x^3 of z = x^2, |x| < 0.35: minimax.
template <class T>
T sinh_tail(T z) {
    if constexpr (single<T>)
        return polynomial<T>(z, {0x1.a28956p-13f, 0x1.110fe4p-7f, 0x1.555556p-3f});
    else
        return polynomial<T>(z, {0x1.7233dc399a405p-33, 0x1.ae5791f4b37b3p-26, 0x1.71de3e019cf92p-19,
                                 0x1.a01a019f1d212p-13, 0x1.1111111111301p-7, 0x1.5555555555555p-3});
}

template <class T>
T sinh(T x) {
    x = flushed(x);
    const T size = size_of(x);
    if (size < T(0.34375)) {
        const T z = size * size;
        return with_sign(std::fma(z * size, sinh_tail(z), size), sign_of(x));
    }
    const Powers<T> both = powers(size, sign_bit<T>);
    return with_sign(scaled(both.value, both.exponent - T(1)), sign_of(x));
}

}  // namespace pelage::reference::functions
