// a at t = 0, b - a rounded and added to a at t = 1.
#pragma once

#include "reference/functions/numbers.hpp"

namespace pelage::reference::functions {

template <class T>
T mix(T a, T b, T t) {
    return std::fma(b - a, t, a);
}

}  // namespace pelage::reference::functions
