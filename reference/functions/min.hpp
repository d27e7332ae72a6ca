// The smaller number; a where they are equal or one of them is NaN.
#pragma once

#include "reference/functions/numbers.hpp"

namespace pelage::reference::functions {

template <class T>
T min(T a, T b) {
    a = flushed(a);
    b = flushed(b);
    return b < a ? b : a;
}

}  // namespace pelage::reference::functions
