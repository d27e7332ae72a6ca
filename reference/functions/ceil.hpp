// The smallest whole number that is not below x.
#pragma once

#include "reference/functions/numbers.hpp"

namespace pelage::reference::functions {

template <class T>
T ceil(T x) {
    return std::ceil(flushed(x));
}

}  // namespace pelage::reference::functions
