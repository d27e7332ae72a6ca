// x between two bounds. A NaN stays one; where low > high the result is high.
#pragma once

#include "reference/functions/max.hpp"
#include "reference/functions/min.hpp"

namespace pelage::reference::functions {

template <class T>
T clamp(T x, T low, T high) {
    return min(max(x, low), high);
}

}  // namespace pelage::reference::functions
