// How a volume becomes a picture: a slice of it, or all that lies along z.
#pragma once

#include "core/experiment.hpp"
#include "core/snapshot.hpp"
#include "io/brush.hpp"
#include "io/colour.hpp"
#include "io/picture.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace pelage {

// Values of columns * rows places, bottom row first, one column for each that was given.
struct Projected {
    std::size_t columns = 0;
    std::size_t rows = 0;
    std::vector<std::vector<double>> values;

    std::vector<std::span<const double>> spans() const { return {values.begin(), values.end()}; }
};

// The output's projection, or that of an output that says nothing: the middle layer.
Projection projection_of(const Output&);

// Columns and rows of the picture of a volume of so many columns, rows and layers.
std::array<std::size_t, 2> projected_size(const Projection&, const std::array<std::size_t, 3>& sides);

// The slice, or the largest value along z, a NaN before all others; of `transparent` alike. `columns`: one value a cell
// of the volume.
Projected projected(const Projection&, const Snapshot& volume, const std::vector<std::span<const double>>& columns);

// Along z, layer 0 in front: a cell covers 1 - exp(-k t^2) of what lies behind it, t from 0 to 1 being the place of its
// value in the range, k = 32 / layers, or 4 where they are fewer than 8. What nothing covers is black.
DeepPicture transparent_picture(const Snapshot& volume, const Brush&, std::span<const double> values,
                                const ValueRange&);

}  // namespace pelage
