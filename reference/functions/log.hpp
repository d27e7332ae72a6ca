// The natural logarithm.
#pragma once

#include "reference/functions/logarithm.hpp"

namespace pelage::reference::functions {

// (ln(1 + f) - f + f^2 / 2) / f^3 for 1 + f from sqrt(1/2) to sqrt(2): minimax.
template <class T>
T log_tail(T f) {
    if constexpr (single<T>)
        return polynomial<T>(f, {0x1.13c2dcp-4f, -0x1.dda1f8p-4f, 0x1.e6dfcap-4f, -0x1.fc3d24p-4f, 0x1.233abep-3f,
                                 -0x1.555b9p-3f, 0x1.99a47ap-3f, -0x1.000008p-2f, 0x1.555548p-2f});
    else
        return polynomial<T>(
            f, {-0x1.8ddb05e2d0df1p-6, 0x1.d2cc4d117becp-5,  -0x1.010d2e7e23f6fp-4, 0x1.bba6f5122e00cp-5,
                -0x1.b458879474025p-5, 0x1.dc97995339e7p-5,  -0x1.00d0224367691p-4, 0x1.116a13e6b76b2p-4,
                -0x1.2489416823eddp-4, 0x1.3b0d7659a70bdp-4, -0x1.5555773c18521p-4, 0x1.745d58f6c70fcp-4,
                -0x1.99999a9cfd606p-4, 0x1.c71c702cd4f0cp-4, -0x1.fffffff3b54b2p-4, 0x1.249249276077ep-3,
                -0x1.555555556b0e1p-3, 0x1.9999999994d48p-3, -0x1.ffffffffffe7cp-3, 0x1.555555555556bp-2});
}

template <class T>
T log(T x) {
    x = flushed(x);
    if (x == T(0)) return -infinite<T>;
    if (x < T(0)) return not_a_number<T>;
    if (!(x < infinite<T>)) return x;
    const Parts<T> parts = parts_around_one(x);
    const T f = parts.mantissa - T(1);
    const T square = f * f;
    const T tail = std::fma(square * f, log_tail(f), T(-0.5) * square);
    const Pair<T> total = quick_sum(parts.exponent * ln2_high<T>, f);
    return total.high + (total.low + std::fma(parts.exponent, ln2_low<T>, tail));
}

}  // namespace pelage::reference::functions
