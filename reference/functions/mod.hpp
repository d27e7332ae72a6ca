// The rest of a / b, of the sign of b.
#pragma once

#include "reference/functions/numbers.hpp"

namespace pelage::reference::functions {

template <class T>
T mod(T a, T b) {
    a = flushed(a);
    b = flushed(b);
    return a - b * std::floor(a / b);
}

}  // namespace pelage::reference::functions
