// The hyperbolic tangent: E / (E + 2) of E = e^(2 |x|) - 1.
#pragma once

#include "reference/functions/power.hpp"
#include "reference/functions/quotient.hpp"

namespace pelage::reference::functions {

template <class T>
T tanh(T x) {
    x = flushed(x);
    const T size = size_of(x);
    if (size < pick<T>(0x1p-12f, 0x1p-27)) return x;
    const T held = size > pick<T>(10.0f, 20.0) ? pick<T>(10.0f, 20.0) : size;
    const Power<T> found = power(held + held, T(0));
    const T scale = power_of_two(found.exponent);
    Pair<T> e = quick_sum(scale - T(1), scale * found.more.high);
    e.low = std::fma(scale, found.more.low, e.low);
    Pair<T> below = sum(e.high, T(2));
    below.low += e.low;
    const Pair<T> ratio = quotient(e, below);
    return with_sign(ratio.high + ratio.low, sign_of(x));
}

}  // namespace pelage::reference::functions
