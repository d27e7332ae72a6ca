// |x|.
#pragma once

#include "reference/functions/numbers.hpp"

namespace pelage::reference::functions {

template <class T>
T abs(T x) {
    return size_of(flushed(x));
}

}  // namespace pelage::reference::functions
