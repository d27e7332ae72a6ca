// The largest whole number that is not above x.
#pragma once

#include "reference/functions/numbers.hpp"

namespace pelage::reference::functions {

template <class T>
T floor(T x) {
    return std::floor(flushed(x));
}

}  // namespace pelage::reference::functions
