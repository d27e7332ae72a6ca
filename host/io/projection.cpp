// See projection.hpp.
#include "io/projection.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace pelage {

namespace {

// Where a cell of a picture lies in the volume: its first cell, and the steps to the right and up.
struct Layout {
    std::size_t first = 0;
    std::size_t right = 1;
    std::size_t up = 1;
};

std::size_t place_of(const Projection& projection, std::size_t count) {
    return std::min(projection.at.value_or(count / 2), count - 1);
}

Layout layout_of(const Projection& projection, const Snapshot& volume) {
    const std::size_t layer = volume.columns * volume.rows;
    if (projection.kind != Projection::Kind::slice) return {0, 1, volume.columns};
    switch (projection.axis) {
        case Axis::x:
            return {place_of(projection, volume.columns), volume.columns, layer};
        case Axis::y:
            return {place_of(projection, volume.rows) * volume.columns, 1, layer};
        default:
            return {place_of(projection, volume.layers) * layer, 1, volume.columns};
    }
}

std::vector<double> largest_along_z(const Snapshot& volume, std::span<const double> values) {
    const std::size_t layer = volume.columns * volume.rows;
    std::vector<double> largest(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(layer));
    for (std::size_t cell = layer; cell < values.size(); ++cell) {
        double& most = largest[cell % layer];
        if (std::isnan(values[cell]) || values[cell] > most) most = values[cell];
    }
    return largest;
}

std::vector<double> sliced(const Layout& layout, std::size_t columns, std::size_t rows,
                           std::span<const double> values) {
    std::vector<double> slice;
    slice.reserve(columns * rows);
    for (std::size_t row = 0; row < rows; ++row) {
        for (std::size_t column = 0; column < columns; ++column)
            slice.push_back(values[layout.first + column * layout.right + row * layout.up]);
    }
    return slice;
}

// How much of what lies behind a value covers.
class Opacity {
public:
    Opacity(const ValueRange& range, std::size_t layers)
        : range_(range), strength_(32.0 / static_cast<double>(std::max<std::size_t>(layers, 8))) {}

    double operator()(double value) const {
        if (std::isnan(value)) return 1.0;
        if (!(range_.high > range_.low)) return 0.0;
        const double t = std::clamp((value - range_.low) / (range_.high - range_.low), 0.0, 1.0);
        return 1.0 - std::exp(-strength_ * t * t);
    }

private:
    ValueRange range_;
    double strength_;
};

}  // namespace

Projection projection_of(const Output& output) { return output.projection.value_or(Projection{}); }

std::array<std::size_t, 2> projected_size(const Projection& projection, const std::array<std::size_t, 3>& sides) {
    if (projection.kind != Projection::Kind::slice || projection.axis == Axis::z) return {sides[0], sides[1]};
    return {projection.axis == Axis::x ? sides[1] : sides[0], sides[2]};
}

Projected projected(const Projection& projection, const Snapshot& volume,
                    const std::vector<std::span<const double>>& columns) {
    Projected result;
    const auto size = projected_size(projection, {volume.columns, volume.rows, volume.layers});
    result.columns = size[0];
    result.rows = size[1];
    const Layout layout = layout_of(projection, volume);
    for (const std::span<const double> values : columns) {
        result.values.push_back(projection.kind == Projection::Kind::slice
                                    ? sliced(layout, result.columns, result.rows, values)
                                    : largest_along_z(volume, values));
    }
    return result;
}

DeepPicture transparent_picture(const Snapshot& volume, const Brush& brush, std::span<const double> values,
                                const ValueRange& range) {
    const Opacity opacity(range, volume.layers);
    const std::size_t layer = volume.columns * volume.rows;
    DeepPicture picture(volume.columns, volume.rows);
    for (std::size_t place = 0; place < layer; ++place) {
        std::array<double, 3> light{};
        double left = 1.0;  // of what lies behind, how much is seen
        for (std::size_t cell = place; cell < values.size() && left > 1e-6; cell += layer) {
            const double share = left * opacity(values[cell]);
            if (share == 0.0) continue;
            const DeepRgb colour = brush.deep(cell);
            for (std::size_t k = 0; k < 3; ++k) light[k] += share * colour[k];
            left -= share;
        }
        DeepRgb& pixel = picture.at(place % volume.columns, volume.rows - 1 - place / volume.columns);
        for (std::size_t k = 0; k < 3; ++k) pixel[k] = static_cast<std::uint16_t>(std::lround(light[k]));
    }
    return picture;
}

}  // namespace pelage
