// The hyperbolic cosine.
#pragma once

#include "reference/functions/steep.hpp"

namespace pelage::reference::functions {

template <class T>
T cosh(T x) {
    const Powers<T> both = powers(size_of(x), Bits<T>{0});
    return scaled(both.value, both.exponent - T(1));
}

}  // namespace pelage::reference::functions
