// The search for concentrations that are no longer numbers. Bits are tested, for a compiler that may assume finite
// arithmetic would drop isfinite(); IS_FINITE of kernels/common/prelude.cl is the same test on a device.
#pragma once

#include "core/tissue.hpp"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace pelage {

constexpr bool is_finite(float value) { return (std::bit_cast<std::uint32_t>(value) & 0x7f800000u) != 0x7f800000u; }

constexpr bool is_finite(double value) {
    constexpr std::uint64_t exponent = 0x7ff0000000000000u;
    return (std::bit_cast<std::uint64_t>(value) & exponent) != exponent;
}

// The first cell, in order of chemical and id, that holds a NaN or an infinity. conc[chemical][cell].
template <class T>
std::optional<NonFinite> first_non_finite(const std::vector<std::vector<T>>& conc) {
    for (std::size_t chemical = 0; chemical < conc.size(); ++chemical) {
        for (std::size_t cell = 0; cell < conc[chemical].size(); ++cell) {
            if (!is_finite(conc[chemical][cell])) return NonFinite{chemical, cell};
        }
    }
    return std::nullopt;
}

}  // namespace pelage
