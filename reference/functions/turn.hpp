// Sine and cosine of an angle less its multiples of pi/2.
#pragma once

#include "reference/functions/far_turn.hpp"

namespace pelage::reference::functions {

template <class T>
struct Angle {
    Pair<T> sine, cosine;  // of what is left
    Bits<T> quarters;      // the multiple; its last two bits count
};

// (sin(r) - r) / r^3 and (cos(r) - 1 + r^2 / 2) / r^4 of z = r^2, |r| < 0.79: minimax.
template <class T>
T sine_tail(T z) {
    if constexpr (single<T>)
        return polynomial<T>(z, {0x1.772d18p-19f, -0x1.a045f2p-13f, 0x1.111162p-7f, -0x1.555556p-3f});
    else
        return polynomial<T>(
            z, {-0x1.a5decc7e94758p-41, 0x1.61159b360f658p-33, -0x1.ae643ea2e69ecp-26, 0x1.71de3a4104cd4p-19,
                -0x1.a01a01a00769cp-13, 0x1.111111111108dp-7, -0x1.5555555555555p-3});
}
template <class T>
T cosine_tail(T z) {
    if constexpr (single<T>)
        return polynomial<T>(z, {0x1.99df46p-16f, -0x1.6c0c16p-10f, 0x1.55554ap-5f});
    else
        return polynomial<T>(z, {-0x1.8f8e0900a589fp-37, 0x1.1ee9ac2468b4p-29, -0x1.27e4f7aa91f51p-22,
                                 0x1.a01a019c2afb3p-16, -0x1.6c16c16c14bf4p-10, 0x1.5555555555549p-5});
}

// Cody and Waite, as in power.hpp: exact for angles up to some ten thousand turns.
template <class T>
Pair<T> near_turn(T size, T quarters) {
    const T rest = std::fma(-quarters, half_pi<T>, size);  // exact
    const Pair<T> second = product(quarters, half_pi_low<T>);
    const Pair<T> left = sum(rest, -second.high);
    const T third = pick<T>(-0x1.ee59dap-50f, -0x1.f1976b7ed8fbcp-110);
    return quick_sum(left.high, std::fma(-quarters, third, left.low - second.low));
}

template <class T>
Pair<T> of_far_turn(const FarTurn<T>& turn) {
    const Pair<T> angle = product(turn.share.high, half_pi<T>);
    const T second = std::fma(turn.share.high, half_pi_low<T>, turn.share.low * half_pi<T>);
    return quick_sum(angle.high, angle.low + second);
}

// For size >= 0; what is infinite has no angle.
template <class T>
Angle<T> angle(T size) {
    T quarters = nearest(size * pick<T>(0x1.45f306p-1f, 0x1.45f306dc9c883p-1));
    Pair<T> r = near_turn(size, quarters);
    if (size > pick<T>(65536.0f, 4194304.0)) {
        const FarTurn<T> far = far_turn(size < infinite<T> ? size : T(2));
        r = of_far_turn(far);
        if (!(size < infinite<T>)) r.high = not_a_number<T>;
        quarters = far.quarters;
    }
    const T z = r.high * r.high;
    const T z_low = std::fma(r.high, r.high, -z);
    const T bend = r.low * std::fma(z, T(-0.5), T(1));
    const T w = T(1) - T(0.5) * z;
    const T lost = ((T(1) - w) - T(0.5) * z) - std::fma(r.high, r.low, T(0.5) * z_low);
    return {quick_sum(r.high, std::fma(z * r.high, sine_tail(z), bend)),
            quick_sum(w, std::fma(z * z, cosine_tail(z), lost)), whole_bits(quarters)};
}

template <class T>
bool is_odd(Bits<T> quarters) {
    return (quarters & 1) != 0;
}

// The sign bit where the second bit of the multiple is set.
template <class T>
Bits<T> half_turn_sign(Bits<T> quarters) {
    return (quarters << (8 * sizeof(T) - 2)) & sign_bit<T>;
}

}  // namespace pelage::reference::functions
