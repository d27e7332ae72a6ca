// 1 / (1 + e^-x). With e = e^-|x|: 1 / (1 + e), for negative x e / (1 + e).
#pragma once

#include "reference/functions/power.hpp"
#include "reference/functions/quotient.hpp"

namespace pelage::reference::functions {

template <class T>
T sigmoid(T x) {
    const Power<T> found = power(not_steep(-size_of(x)), T(0));
    const Pair<T> y = one_more(found.more);
    const T scale = power_of_two(found.exponent < T(-64) ? T(-64) : found.exponent);
    Pair<T> below = quick_sum(T(1), scale * y.high);
    below.low = std::fma(scale, y.low, below.low);
    const bool falls = x < T(0);
    const Pair<T> ratio = quotient(falls ? y : Pair<T>{T(1), T(0)}, below);
    const T value = ratio.high + ratio.low;
    return falls ? scaled(value, found.exponent) : value;
}

}  // namespace pelage::reference::functions
