// The angle from the x axis to the point (x, y).
#pragma once

#include "reference/functions/arc.hpp"
#include "reference/functions/logarithm.hpp"

namespace pelage::reference::functions {

// The arc of less / more, taken from `quarters`; 0 <= less <= more, no NaN.
template <class T>
T arc_of(T less, T more, T quarters, Bits<T> down) {
    if (less == T(0) || (more == infinite<T> && less < infinite<T>))
        return arc_from(quarters, Ratio<T>{{T(0), T(0)}, false}, down);
    if (less == more) return arc_from(quarters, Ratio<T>{{T(0), T(0)}, true}, down);
    const Parts<T> above = parts_around_one(less);
    const Parts<T> below = parts_around_one(more);
    const T exponent = above.exponent - below.exponent;
    // Of the tangent, when the arc is the tangent; and where that is 0 at the latest.
    const T tiny = pick<T>(-40.0f, -80.0);
    const T least = pick<T>(-200.0f, -1200.0);
    const T scale = power_of_two(exponent < tiny ? tiny : exponent);
    Ratio<T> found = ratio(above.mantissa, scale, below.mantissa);
    if (exponent < tiny && quarters == T(0))
        return scaled(found.tangent.high + found.tangent.low, exponent < least ? least : exponent);
    if (!found.middle) found.tangent = {found.tangent.high * scale, found.tangent.low * scale};
    return arc_from(quarters, found, down);
}

template <class T>
T atan2(T y, T x) {
    if (std::isnan(x) || std::isnan(y)) return x + y;
    const T up = size_of(flushed(y));
    const T along = size_of(flushed(x));
    const bool steep = up > along;
    const bool left = sign_of(x) != 0;
    const T quarters = steep ? T(1) : left ? T(2) : T(0);
    const Bits<T> down = left != steep ? sign_bit<T> : Bits<T>{0};
    return with_sign(arc_of(steep ? along : up, steep ? up : along, quarters, down), sign_of(y));
}

}  // namespace pelage::reference::functions
