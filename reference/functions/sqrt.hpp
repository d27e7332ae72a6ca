// The square root.
#pragma once

#include "reference/functions/numbers.hpp"

namespace pelage::reference::functions {

template <class T>
T sqrt(T x) {
    return std::sqrt(flushed(x));
}

}  // namespace pelage::reference::functions
