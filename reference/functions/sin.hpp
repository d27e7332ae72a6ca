// The sine of an angle in radians.
#pragma once

#include "reference/functions/turn.hpp"

namespace pelage::reference::functions {

template <class T>
T sin(T x) {
    x = flushed(x);
    const Angle<T> found = angle(size_of(x));
    const T size = is_odd<T>(found.quarters) ? found.cosine.high : found.sine.high;
    return with_sign(size, half_turn_sign<T>(found.quarters) ^ sign_of(x));
}

}  // namespace pelage::reference::functions
