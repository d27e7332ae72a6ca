// Values in rows and columns, as patterns are measured.
#pragma once

#include <cstddef>
#include <span>

namespace pelage::stats {

struct Grid {
    std::span<const double> values;  // row-major, bottom row first
    std::size_t columns = 0;
    std::size_t rows = 0;
    bool wrap = false;  // opposite edges are neighbours
};

// Throws Error where the values are not columns * rows finite numbers, or none.
void check(const Grid&);

}  // namespace pelage::stats
