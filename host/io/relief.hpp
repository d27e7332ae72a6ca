// A chemical as a surface: height and normal maps for programs that render in three dimensions.
#pragma once

#include "io/colour.hpp"
#include "io/picture.hpp"

#include <cstddef>
#include <span>

namespace pelage {

// Black at the low end of the range, white at the high one, which values beyond keep; half grey where the range is
// empty or a point, black where a value is NaN. `values` has the bottom row first, the picture the top line.
GreyPicture height_map(std::span<const double> values, std::size_t columns, std::size_t rows, const ValueRange&);

// How values become slopes.
struct Slopes {
    double strength = 1.0;  // height, in cells, of one unit of the chemical
    double width = 1.0;     // of an element, in cells
    double height = 1.0;
    bool wrap = false;  // opposite edges are neighbours; else an edge takes the slope towards its inner neighbour
};

// The direction that is at right angles to the surface, in tangent space: red to the right, green up (as in OpenGL and
// Blender), blue out of the picture; -1..1 is carried to 0..255 or 0..65535. From central differences.
Picture normal_map(std::span<const double> values, std::size_t columns, std::size_t rows, const Slopes&);
DeepPicture normal_map_deep(std::span<const double> values, std::size_t columns, std::size_t rows, const Slopes&);

}  // namespace pelage
