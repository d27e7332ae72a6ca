// x between two bounds. A NaN stays one; where low > high the result is high.
#pragma once

#include "reference/functions/numbers.hpp"

namespace pelage::reference::functions {

template <class T>
T clamp(T x, T low, T high) {
    const T raised = x < low ? low : x;
    return high < raised ? high : raised;
}

}  // namespace pelage::reference::functions
