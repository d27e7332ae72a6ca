// 3 t^2 - 2 t^3 of t = (x - low) / (high - low), which is held between 0 and 1.
#pragma once

#include "reference/functions/numbers.hpp"

namespace pelage::reference::functions {

template <class T>
T smoothstep(T low, T high, T x) {
    low = flushed(low);
    const T t = (flushed(x) - low) / (flushed(high) - low);
    const T raised = t < T(0) ? T(0) : t;
    const T held = raised > T(1) ? T(1) : raised;
    return (held * held) * std::fma(T(-2), held, T(3));
}

}  // namespace pelage::reference::functions
