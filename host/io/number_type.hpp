// Numbers in other programs' arrays: how many bytes one has, and how it becomes a double, exactly.
#pragma once

#include "io/file_bytes.hpp"

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace pelage {

struct NumberType {
    std::size_t size = 0;  // 0: not known
    double (*load)(const char*) = nullptr;
};

template <class T>
NumberType number_type() {
    return {sizeof(T), [](const char* from) { return static_cast<double>(load<T>(from)); }};
}

// binary16 of IEEE 754: 5 bits of exponent, 10 of fraction.
inline double of_half(std::uint16_t bits) {
    const int exponent = bits >> 10 & 31, fraction = bits & 1023;
    double size = std::ldexp(exponent == 0 ? fraction : 1024 + fraction, exponent == 0 ? -24 : exponent - 25);
    if (exponent == 31)
        size = fraction == 0 ? std::numeric_limits<double>::infinity() : std::numeric_limits<double>::quiet_NaN();
    return std::copysign(size, (bits & 0x8000) != 0 ? -1.0 : 1.0);
}
inline NumberType half_type() {
    return {sizeof(std::uint16_t), [](const char* from) { return of_half(load<std::uint16_t>(from)); }};
}

// bfloat16: the upper half of a float.
inline NumberType bfloat_type() {
    return {sizeof(std::uint16_t), [](const char* from) {
                return double{std::bit_cast<float>(std::uint32_t{load<std::uint16_t>(from)} << 16)};
            }};
}

}  // namespace pelage
