// a at t = 0, and at t = 1 a + (b - a) as it is rounded.
#pragma once

#include "reference/functions/numbers.hpp"

namespace pelage::reference::functions {

template <class T>
T mix(T a, T b, T t) {
    a = flushed(a);
    return a + (flushed(b) - a) * flushed(t);
}

}  // namespace pelage::reference::functions
