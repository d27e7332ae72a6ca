// Arcs of a sine of at most 1/2.
#pragma once

#include "reference/functions/quotient.hpp"

namespace pelage::reference::functions {

// arcsin(s) = s + s z tail(z), z = s^2: minimax.
template <class T>
T arc_sine_tail(T z) {
    if constexpr (single<T>)
        return polynomial<T>(
            z, {0x1.33d432p-5f, 0x1.d7924cp-7f, 0x1.04af34p-5f, 0x1.6caab6p-5f, 0x1.33389ep-4f, 0x1.55554cp-3f});
    else
        return polynomial<T>(z, {0x1.0b45ea63b1699p-5, -0x1.57fad21f83513p-6, 0x1.639a8a1bbdd02p-6,
                                 0x1.e5fbe63872ca6p-9, 0x1.613c1e9096db8p-7, 0x1.75859da822552p-7, 0x1.ca1f8af264013p-7,
                                 0x1.1c49f077d2818p-6, 0x1.6e8bdedebfb72p-6, 0x1.f1c71a95002f6p-6, 0x1.6db6db721247bp-5,
                                 0x1.333333332e133p-4, 0x1.5555555555577p-3});
}

// The arc is high + low. From 1/2 on it is half the angle between the arc of `size` and pi/2: its sine is
// sqrt((1 - size) / 2).
template <class T>
Pair<T> arc_sine(T size) {
    if (!(size >= T(0.5))) {
        const T z = size * size;
        return {size, std::fma(size, z * arc_sine_tail(z), T(0))};
    }
    const T z = std::fma(T(-0.5), size, T(0.5));  // exact
    const Pair<T> sine = root(Pair<T>{z, T(0)});
    return {sine.high, std::fma(sine.high, z * arc_sine_tail(z), sine.low)};
}

}  // namespace pelage::reference::functions
