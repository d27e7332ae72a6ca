// Free cells as a picture, as the published program draws them.
#pragma once

#include "core/experiment.hpp"
#include "core/snapshot.hpp"
#include "io/brush.hpp"
#include "io/colour.hpp"
#include "io/picture.hpp"

#include <array>
#include <cstddef>
#include <optional>

namespace pelage {

enum class CellShape {
    circle,   // of radius 1
    hexagon,  // pointing up, as wide as the circle: hexagonal grids close up
    voronoi   // what is nearer to this cell than to any other, within a square of half side 1.5
};

double margin_of(CellShape);  // that is drawn around the centres of cells

struct CellBox {  // around the centres of cells, in units of cell radius
    std::array<double, 2> low{};
    std::array<double, 2> high{};
};

CellBox box_around(const Snapshot&);  // a point, (0, 0), where no cell is at a finite place

struct CellDrawing {
    CellShape shape = CellShape::circle;
    bool polarity_marks = false;  // a line from the centre along the polarity
    std::size_t size = 800;  // of the longer side, in pixels; up to 4096 where cells would be smaller than 2 pixels
    std::optional<CellBox> box = {};  // what is shown instead of the tissue's own bounding box
};

// The tissue's bounding box on white, with edges antialiased (voronoi: sharp); a later cell covers an earlier one.
Picture draw_cells(const Snapshot&, const Brush&, const CellDrawing&);
// The output's chemical, in the values' own range or the output's.
Picture draw_cells(const Snapshot&, const Output&, const CellDrawing&);

}  // namespace pelage
