// 0 for x < edge, else 1.
#pragma once

#include "reference/functions/numbers.hpp"

namespace pelage::reference::functions {

template <class T>
T step(T edge, T x) {
    return flushed(x) < flushed(edge) ? T(0) : T(1);
}

}  // namespace pelage::reference::functions
