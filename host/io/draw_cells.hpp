// Free cells as a picture, as the published program draws them.
#pragma once

#include "core/experiment.hpp"
#include "core/snapshot.hpp"
#include "io/brush.hpp"
#include "io/colour.hpp"
#include "io/picture.hpp"

#include <cstddef>

namespace pelage {

enum class CellShape {
    circle,   // of radius 1
    hexagon,  // pointing up, as wide as the circle: hexagonal grids close up
    voronoi   // what is nearer to this cell than to any other, within a square of half side 1.5
};

struct CellDrawing {
    CellShape shape = CellShape::circle;
    bool polarity_marks = false;  // a line from the centre along the polarity
    std::size_t size = 800;  // of the longer side, in pixels; up to 4096 where cells would be smaller than 2 pixels
};

// The tissue's bounding box on white, with edges antialiased (voronoi: sharp); a later cell covers an earlier one.
Picture draw_cells(const Snapshot&, const Brush&, const CellDrawing&);
// The output's chemical, in the values' own range or the output's.
Picture draw_cells(const Snapshot&, const Output&, const CellDrawing&);

}  // namespace pelage
