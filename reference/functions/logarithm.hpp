// A positive number as 2^exponent times a number around 1.
#pragma once

#include "reference/functions/numbers.hpp"

namespace pelage::reference::functions {

// x = mantissa 2^exponent, with the mantissa from sqrt(1/2) to sqrt(2).
template <class T>
struct Parts {
    T mantissa, exponent;
};

// Of a number that is normal, or in double precision subnormal.
template <class T>
Parts<T> parts_around_one(T x) {
    T lifted = T(0);
    if constexpr (!single<T>) {
        if (x < T(0x1p-1022)) {
            x *= T(0x1p54);
            lifted = T(54);
        }
    }
    const Bits<T> root_of_half = single<T> ? Bits<T>(0x3f3504f3) : Bits<T>(0x3fe6a09e667f3bcd);
    const Bits<T> above = bits_of(x) - root_of_half;
    const Bits<T> fraction = above & ((Bits<T>{1} << fraction_bits<T>)-1);
    // The exponent may be below 0: it is counted from a bias.
    const Bits<T> biased = (above + (bits_of(T(1)) << 1)) >> fraction_bits<T>;
    const T bias = pick<T>(254.0f, 2046.0);
    const T exponent = (number_of<T>(bits_of(whole_shift<T>) + biased) - whole_shift<T>)-(bias + lifted);
    return {number_of<T>(fraction + root_of_half), exponent};
}

}  // namespace pelage::reference::functions
