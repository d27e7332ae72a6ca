// The cosine of an angle in radians.
#pragma once

#include "reference/functions/turn.hpp"

namespace pelage::reference::functions {

template <class T>
T cos(T x) {
    const Angle<T> found = angle(size_of(flushed(x)));
    const T size = is_odd<T>(found.quarters) ? found.sine.high : found.cosine.high;
    return with_sign(size, half_turn_sign<T>(found.quarters + 1));
}

}  // namespace pelage::reference::functions
