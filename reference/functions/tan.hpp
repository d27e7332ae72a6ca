// The tangent of an angle in radians.
#pragma once

#include "reference/functions/quotient.hpp"
#include "reference/functions/turn.hpp"

namespace pelage::reference::functions {

template <class T>
T tan(T x) {
    x = flushed(x);
    if (size_of(x) < pick<T>(0x1p-13f, 0x1p-28)) return x;
    const Angle<T> found = angle(size_of(x));
    const bool odd = is_odd<T>(found.quarters);
    const Bits<T> sign = sign_of(found.sine.high);
    const Pair<T> sine{with_sign(found.sine.high, sign), with_sign(found.sine.low, sign)};
    const Pair<T> ratio = odd ? quotient(found.cosine, sine) : quotient(sine, found.cosine);
    const Bits<T> turned = odd ? sign_bit<T> : Bits<T>{0};
    return with_sign(ratio.high + ratio.low, (sign ^ turned) ^ sign_of(x));
}

}  // namespace pelage::reference::functions
