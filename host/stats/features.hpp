// Spots, stripes and holes: pieces of a pattern that hang together.
#pragma once

#include "stats/grid.hpp"

#include <cstddef>

namespace pelage::stats {

struct Features {
    std::size_t count = 0;  // pieces above the middle between lowest and highest value
    double size = 0.0;      // of them, in cells, on the average
    double coverage = 0.0;  // share of all cells that lie in them
};

// Cells hang together along edges. A pattern whose values are all equal has none.
Features features_of(const Grid&);

// 1: all slopes lie along one direction, as in parallel stripes; 0: they lie along all directions alike. Of the
// gradient tensor: |sum (gx + i gy)^2| / sum (gx^2 + gy^2).
double orientation_order(const Grid&);

}  // namespace pelage::stats
