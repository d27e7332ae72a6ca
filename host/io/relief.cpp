// See relief.hpp.
#include "io/relief.hpp"

#include "core/error.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace pelage {
namespace {

constexpr double full_scale = 65535.0;

void check(std::span<const double> values, std::size_t columns, std::size_t rows) {
    if (values.size() == columns * rows && !values.empty()) return;
    throw Error(fmt::format("{} values do not make a surface of {} x {}", values.size(), columns, rows));
}

// An element's neighbours along one axis, and how many elements lie from one to the other.
struct Pair {
    std::size_t below;
    std::size_t above;
    double apart;
};

Pair neighbours(std::size_t at, std::size_t count, bool wrap) {
    if (wrap) return {(at + count - 1) % count, (at + 1) % count, 2.0};
    const auto below = at == 0 ? at : at - 1;
    const auto above = at + 1 == count ? at : at + 1;
    return {below, above, std::max(1.0, static_cast<double>(above - below))};
}

std::array<double, 3> normal(double across, double up) {
    const double length = std::sqrt(across * across + up * up + 1.0);
    if (!std::isfinite(length)) return {0.0, 0.0, 1.0};
    return {-across / length, -up / length, 1.0 / length};
}

template <class Pixel>
Pixel encoded(const std::array<double, 3>& direction) {
    using Sample = typename Pixel::value_type;
    constexpr double largest = static_cast<Sample>(-1);
    Pixel pixel;
    for (std::size_t i = 0; i < 3; ++i) {
        pixel[i] = static_cast<Sample>(std::lround((direction[i] + 1.0) / 2 * largest));
    }
    return pixel;
}

template <class Pixel>
PictureOf<Pixel> normals(std::span<const double> values, std::size_t columns, std::size_t rows, const Slopes& slopes) {
    check(values, columns, rows);
    PictureOf<Pixel> picture(columns, rows);
    for (std::size_t row = 0; row < rows; ++row) {
        const Pair y = neighbours(row, rows, slopes.wrap);
        for (std::size_t column = 0; column < columns; ++column) {
            const Pair x = neighbours(column, columns, slopes.wrap);
            const double across = values[row * columns + x.above] - values[row * columns + x.below];
            const double up = values[y.above * columns + column] - values[y.below * columns + column];
            picture.at(column, rows - 1 - row) = encoded<Pixel>(normal(
                slopes.strength * across / (x.apart * slopes.width), slopes.strength * up / (y.apart * slopes.height)));
        }
    }
    return picture;
}

}  // namespace

GreyPicture height_map(std::span<const double> values, std::size_t columns, std::size_t rows, const ValueRange& range) {
    check(values, columns, rows);
    const double length = range.empty() ? 0.0 : range.high - range.low;
    const bool flat = length == 0.0 || !std::isfinite(length);
    GreyPicture picture(columns, rows);
    for (std::size_t row = 0; row < rows; ++row) {
        for (std::size_t column = 0; column < columns; ++column) {
            const double value = values[row * columns + column];
            const double place = flat ? 0.5 : std::clamp((value - range.low) / length, 0.0, 1.0);
            picture.at(column, rows - 1 - row) = {
                static_cast<std::uint16_t>(std::isnan(value) ? 0 : std::lround(place * full_scale))};
        }
    }
    return picture;
}

Picture normal_map(std::span<const double> values, std::size_t columns, std::size_t rows, const Slopes& slopes) {
    return normals<Rgb>(values, columns, rows, slopes);
}

DeepPicture normal_map_deep(std::span<const double> values, std::size_t columns, std::size_t rows,
                            const Slopes& slopes) {
    return normals<DeepRgb>(values, columns, rows, slopes);
}

}  // namespace pelage
