// The arc whose sine is x.
#pragma once

#include "reference/functions/arc_sine.hpp"

namespace pelage::reference::functions {

template <class T>
T asin(T x) {
    x = flushed(x);
    const T size = size_of(x);
    if (size > T(1)) return not_a_number<T>;
    const Pair<T> arc = arc_sine(size);
    if (!(size >= T(0.5))) return with_sign(arc.high + arc.low, sign_of(x));
    const Pair<T> rest = quick_sum(half_pi<T>, T(-2) * arc.high);
    return with_sign(rest.high + (rest.low + std::fma(T(-2), arc.low, half_pi_low<T>)), sign_of(x));
}

}  // namespace pelage::reference::functions
