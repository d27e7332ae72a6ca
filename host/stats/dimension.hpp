// How a pattern fills the plane.
#pragma once

#include "stats/grid.hpp"

namespace pelage::stats {

// The fractal dimension by counting boxes, of the cells above the middle between lowest and highest value: the slope of
// log(boxes with such a cell) over log(1 / side), for sides of 2, 4, 8 ... cells up to a quarter of what they span.
// 2: filled; 1: a line; 0 where there are fewer than two such sides, or no such cells.
double dimension_of(const Grid&);

}  // namespace pelage::stats
