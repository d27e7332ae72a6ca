// The arc whose cosine is x.
#pragma once

#include "reference/functions/arc_sine.hpp"

namespace pelage::reference::functions {

template <class T>
T acos(T x) {
    x = flushed(x);
    const T size = size_of(x);
    if (size > T(1)) return not_a_number<T>;
    const Pair<T> arc = arc_sine(size);
    if (!(size >= T(0.5))) {
        const Pair<T> total = quick_sum(half_pi<T>, -with_sign(arc.high, sign_of(x)));
        return total.high + (total.low + (half_pi_low<T> + -with_sign(arc.low, sign_of(x))));
    }
    if (x > T(0)) return T(2) * arc.high + T(2) * arc.low;
    const Pair<T> total = quick_sum(T(2) * half_pi<T>, T(-2) * arc.high);
    return total.high + (total.low + (T(2) * half_pi_low<T> + T(-2) * arc.low));
}

}  // namespace pelage::reference::functions
