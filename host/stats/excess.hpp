// Numbers whose squares no double holds are measured a power of two smaller, or larger.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

namespace pelage::stats {

// The power of two that brings the values to where their squares are neither infinite nor 0; 0: they are there.
inline int excess_of(std::span<const double> values) {
    double most = 0.0;
    for (const double value : values) most = std::max(most, std::fabs(value));
    if (most == 0.0 || (most > 1e-100 && most < 1e100)) return 0;
    return std::ilogb(most);
}

}  // namespace pelage::stats
