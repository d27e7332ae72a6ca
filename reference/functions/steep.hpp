// Sums and differences of powers of e.
#pragma once

#include "reference/functions/power.hpp"
#include "reference/functions/quotient.hpp"

namespace pelage::reference::functions {

template <class T>
struct Powers {
    T value, exponent;
};

// e^size + e^-size is value 2^exponent, size >= 0; with the sign bit in `down` e^size - e^-size is.
template <class T>
Powers<T> powers(T size, Bits<T> down) {
    const Power<T> found = power(not_steep(size), T(0));
    const Pair<T> y = one_more(found.more);
    const Pair<T> inverse = quotient({T(1), T(0)}, y);
    const T shrunk = T(-2) * (found.exponent > T(30) ? T(30) : found.exponent);
    const T scale = with_sign(power_of_two(shrunk), down);
    const Pair<T> both = sum(y.high, scale * inverse.high);
    return {both.high + (both.low + std::fma(scale, inverse.low, y.low)), found.exponent};
}

}  // namespace pelage::reference::functions
