// The contact sheet of a sweep: all tiles in one picture.
#pragma once

#include "core/experiment.hpp"
#include "io/colour.hpp"
#include "io/picture.hpp"
#include "sweep/design.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace pelage::sweep {

// Where tiles lie: across by the first axis, upwards by the others and the replicates; without axes row by row from the
// top, `across` of them in each, or about as many across as down where that is 0.
struct Layout {
    std::size_t across = 1, down = 1;
    bool from_below = false;
};
Layout layout(const std::vector<Axis>&, std::size_t tiles, std::size_t across = 0);

inline constexpr std::size_t gap = 4;  // pixels between tiles

struct TilePicture {
    std::size_t columns = 0, rows = 0;
    std::vector<double> values;  // bottom row first, of `rgb` reds, greens and blues; empty: the tile is not there
};

// All in one range: the output's own, or from the lowest to the highest value; `rgb` knows none. Tiles smaller than
// `least` pixels are enlarged by a whole factor. A place is as large as the largest tile; a smaller one lies in its
// lower left corner.
struct Mosaic {
    Picture picture{0, 0};
    std::size_t tile_columns = 0, tile_rows = 0;  // pixels
    ValueRange range;
};
Mosaic mosaic(const std::vector<TilePicture>&, const Layout&, const Output&, std::size_t least);

}  // namespace pelage::sweep
