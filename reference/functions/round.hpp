// The nearest whole number; halves go away from 0.
#pragma once

#include "reference/functions/numbers.hpp"

namespace pelage::reference::functions {

template <class T>
T round(T x) {
    const T size = size_of(flushed(x));
    const T below = std::floor(size);
    return with_sign(size - below >= T(0.5) ? below + T(1) : below, sign_of(x));
}

}  // namespace pelage::reference::functions
