// See brush.hpp.
#include "io/brush.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pelage {

namespace {

template <class Pixel>
Pixel mixed_from(const std::vector<std::span<const double>>& columns, std::size_t cell) {
    using Channel = typename Pixel::value_type;
    constexpr double full = std::numeric_limits<Channel>::max();
    Pixel pixel{};
    for (std::size_t i = 0; i < pixel.size(); ++i) {
        const double value = columns[i][cell];
        if (std::isnan(value)) return {std::numeric_limits<Channel>::max(), 0, std::numeric_limits<Channel>::max()};
        pixel[i] = static_cast<Channel>(std::lround(full * std::clamp(value, 0.0, 1.0)));
    }
    return pixel;
}

template <class Pixels, class Colour>
Pixels laid_out(const Brush& brush, std::size_t columns, std::size_t rows, const Colour& colour) {
    if (brush.cells() != columns * rows)
        throw Error(fmt::format("{} values cannot be drawn as {} x {} pixels", brush.cells(), columns, rows));
    Pixels picture(columns, rows);
    for (std::size_t row = 0; row < rows; ++row) {
        for (std::size_t column = 0; column < columns; ++column)
            picture.at(column, rows - 1 - row) = colour(row * columns + column);
    }
    return picture;
}

}  // namespace

Brush::Brush(const Output& output, std::vector<std::span<const double>> columns, const ValueRange& found)
    : columns_(std::move(columns)) {
    if (columns_.size() == 1) colours_.emplace(output, found);
}

Rgb Brush::operator()(std::size_t cell) const {
    return colours_ ? (*colours_)(columns_[0][cell]) : mixed_from<Rgb>(columns_, cell);
}

DeepRgb Brush::deep(std::size_t cell) const {
    return colours_ ? colours_->deep(columns_[0][cell]) : mixed_from<DeepRgb>(columns_, cell);
}

Picture render(const Brush& brush, std::size_t columns, std::size_t rows) {
    return laid_out<Picture>(brush, columns, rows, brush);
}

Picture render(std::span<const double> values, std::size_t columns, std::size_t rows, const Output& output) {
    return render(Brush(output, {values}, output.range ? ValueRange{} : range_of(values)), columns, rows);
}

DeepPicture render_deep(const Brush& brush, std::size_t columns, std::size_t rows) {
    return laid_out<DeepPicture>(brush, columns, rows, [&](std::size_t cell) { return brush.deep(cell); });
}

}  // namespace pelage
