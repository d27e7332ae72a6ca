// The arc whose tangent is x.
#pragma once

#include "reference/functions/arc.hpp"

namespace pelage::reference::functions {

template <class T>
T atan(T x) {
    x = flushed(x);
    const T size = size_of(x);
    if (size < pick<T>(0x1p-12f, 0x1p-27)) return x;
    const bool steep = size > T(1);
    const T held = size > T(0x1p60) ? T(0x1p60) : size;
    const Ratio<T> found = steep ? ratio(T(1), T(1), held) : ratio(size, T(1), T(1));
    return with_sign(arc_from(steep ? T(1) : T(0), found, steep ? sign_bit<T> : Bits<T>{0}), sign_of(x));
}

}  // namespace pelage::reference::functions
