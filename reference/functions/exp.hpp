// e^x.
#pragma once

#include "reference/functions/power.hpp"

namespace pelage::reference::functions {

template <class T>
T exp(T x) {
    const Power<T> found = power(not_steep(x), T(0));
    const Pair<T> y = one_more(found.more);
    return scaled(y.high + y.low, found.exponent);
}

}  // namespace pelage::reference::functions
