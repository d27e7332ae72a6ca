// Arcs of a tangent.
#pragma once

#include "reference/functions/quotient.hpp"

namespace pelage::reference::functions {

// (arctan(q) - q) / q^3 of z = q^2, |q| <= tan(pi/8): minimax.
template <class T>
T arc_tail(T z) {
    if constexpr (single<T>)
        return polynomial<T>(z, {-0x1.f2f55ep-5f, 0x1.b2276ep-4f, -0x1.23b9d4p-3f, 0x1.9991e4p-3f, -0x1.55554ap-2f});
    else
        return polynomial<T>(z,
                             {-0x1.256359424e5eap-6, 0x1.37d287c62948bp-5, -0x1.9cd18d7209246p-5, 0x1.df0f0aa7dd591p-5,
                              -0x1.10ebb416c6636p-4, 0x1.3b1118c57d137p-4, -0x1.745cf8d81ec5dp-4, 0x1.c71c70e5f0464p-4,
                              -0x1.24924922ad28p-3, 0x1.9999999995866p-3, -0x1.555555555553dp-2});
}

template <class T>
struct Ratio {
    Pair<T> tangent;
    bool middle;
};

// less scale / more, 0 <= less scale <= more: below tan(pi/8) less / more itself, without the scale. Else `middle`
// holds and the tangent is that of the arc less pi/4, (less scale - more) / (less scale + more).
template <class T>
Ratio<T> ratio(T less, T scale, T more) {
    const T share = less * scale;
    if (share > T(0.4140625) * more) return {quotient(sum(share, -more), sum(share, more)), true};
    return {quotient(Pair<T>{less, T(0)}, Pair<T>{more, T(0)}), false};
}

// quarters pi/2 and, for the middle, pi/4, and the arc of the tangent; where the sign bit is given in `down`, quarters
// pi/2 less the rest.
template <class T>
T arc_from(T quarters, const Ratio<T>& ratio, Bits<T> down) {
    const T start = quarters + (ratio.middle ? with_sign(T(0.5), down) : T(0));
    const Pair<T> base = product(start, half_pi<T>);
    const T z = ratio.tangent.high * ratio.tangent.high;
    const T bend = ratio.tangent.low * (T(1) - z);
    const T tail = std::fma(ratio.tangent.high, z * arc_tail(z), bend);
    const Pair<T> total = quick_sum(base.high, with_sign(ratio.tangent.high, down));
    return total.high + (total.low + (std::fma(start, half_pi_low<T>, base.low) + with_sign(tail, down)));
}

}  // namespace pelage::reference::functions
