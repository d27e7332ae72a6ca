// sqrt(a^2 + b^2), by squares that neither overflow nor vanish.
#pragma once

#include "reference/functions/quotient.hpp"

namespace pelage::reference::functions {

template <class T>
T hypot(T a, T b) {
    const T one = size_of(flushed(a));
    const T other = size_of(flushed(b));
    if (one == infinite<T> || other == infinite<T>) return infinite<T>;
    if (std::isnan(a) || std::isnan(b)) return a + b;
    T more = one < other ? other : one;
    T less = one < other ? one : other;
    const bool large = more > pick<T>(0x1p+40f, 0x1p+500);
    const bool small = more < pick<T>(0x1p-40f, 0x1p-500);
    const T up = pick<T>(0x1p+80f, 0x1p+600);
    const T down = pick<T>(0x1p-80f, 0x1p-600);
    const T scale = large ? down : small ? up : T(1);
    more = more * scale;
    less = flushed(less * scale);
    const Pair<T> square = product(more, more);
    const Pair<T> added = product(less, less);
    Pair<T> both = quick_sum(square.high, flushed(added.high));
    both.low += flushed(square.low) + flushed(added.low);
    const Pair<T> found = root(both);
    return (found.high + found.low) * (large ? up : small ? down : T(1));
}

}  // namespace pelage::reference::functions
