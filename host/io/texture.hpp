// Cells' values as a smooth texture of any size.
#pragma once

#include "core/experiment.hpp"
#include "core/snapshot.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace pelage {

// One field of columns x rows texels, bottom row first, for each array of `values` (one value a cell of the snapshot).
// A texel is the mean of the cells around it with weights (1 - q)^4 (4 q + 1) / (q^2 + 1/4), q = distance / r:
// Wendland's C2 kernel, sharpened so that a cell's own value prevails at its centre. Normalised weights are never
// negative and add up to 1 in every texel, so no value leaves the range of the cells. r is 1.5 times the mean distance
// of the cell's nearest six, or one texel where that is larger. A texel that no cell reaches takes the nearest
// cell's value. A lattice is stretched over the texture, and continued around its edges when `wrap`, so that copies of
// the texture fit together; free cells' bounding box is widened to the texture's proportions instead. Throws Error when
// there are no cells or no texels.
std::vector<Field> interpolate(const Snapshot&, const std::vector<std::vector<double>>& values, std::size_t columns,
                               std::size_t rows, bool wrap);

// Width and height of a texel of such a texture, in units of cell radius.
std::array<double, 2> texel_size(const Snapshot&, std::size_t columns, std::size_t rows);

// True when the experiment's lattice or volume is a torus.
bool wraps(const Experiment&);

}  // namespace pelage
