// Where the cells of grids and circles lie, in the precision of the run. In float each sum is rounded at the same
// places as in the published program.
#pragma once

#include "core/experiment.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace pelage {

// Rows of a hexagonal grid lie 1.7321 apart.
template <class T>
inline constexpr T hex_row = std::is_same_v<T, float> ? static_cast<T>(1.7321f) : static_cast<T>(1.7321);
template <class T>
inline constexpr T half_hex_row = std::is_same_v<T, float> ? static_cast<T>(0.866f) : static_cast<T>(0.866);

// The place of the i-th of `count` cells that lie 2 apart around `centre`.
template <class T>
T spaced(T centre, std::int64_t i, std::int64_t count) {
    return static_cast<T>(centre + (static_cast<double>(i) - static_cast<double>(count) / 2.0) * 2 + 1);
}

// The square of elements from which a sqr_circle or hex_circle is cut. What lies inside is decided in float, as the
// published program does, so that a circle has the same cells in any precision.
class Circle {
public:
    explicit Circle(const CreateGrid&);

    std::int64_t begin() const { return hex_ ? -n_ : 0; }  // of rows and columns
    std::int64_t end() const { return n_; }
    bool inside(std::int64_t row, std::int64_t column) const { return element(row, column).inside; }
    std::size_t count() const;  // elements inside, without visiting each

    template <class T>
    std::array<T, 2> place(std::int64_t row, std::int64_t column) const {
        if (!hex_) return {spaced(static_cast<T>(x_), column, n_), spaced(static_cast<T>(y_), row, n_)};
        const T shift = row % 2 != 0 ? T(1) : T(0);
        const T x = static_cast<T>(x_) + static_cast<T>(column * 2);
        return {x + shift, static_cast<T>(y_) + static_cast<T>(row) * hex_row<T>};
    }

private:
    struct Element {
        bool right;  // not left of the centre
        bool inside;
    };
    Element element(std::int64_t row, std::int64_t column) const {
        return hex_ ? hex(row, column) : square(row, column);
    }
    Element square(std::int64_t row, std::int64_t column) const;
    Element hex(std::int64_t row, std::int64_t column) const;

    bool hex_;
    std::int64_t n_;
    double x_, y_;
};

// Calls each(x, y) for the centre of every cell of a grid or circle, in order of creation.
template <class T, class Each>
void for_each_centre(const CreateGrid& grid, Each each) {
    const auto n = static_cast<std::int64_t>(grid.columns);
    const auto rows = static_cast<std::int64_t>(grid.rows);
    const T centre_x = static_cast<T>(grid.x);
    const T centre_y = static_cast<T>(grid.y);
    if (grid.arrangement == Arrangement::sqr_circle || grid.arrangement == Arrangement::hex_circle) {
        const Circle circle(grid);
        for (std::int64_t row = circle.begin(); row < circle.end(); ++row) {
            for (std::int64_t column = circle.begin(); column < circle.end(); ++column) {
                if (!circle.inside(row, column)) continue;
                const auto [x, y] = circle.place<T>(row, column);
                each(x, y);
            }
        }
        return;
    }
    const bool hex = grid.arrangement == Arrangement::hex_grid;
    for (std::int64_t row = 0; row < rows; ++row) {
        const T place = static_cast<T>(row) - static_cast<T>(rows) / T(2);
        const T y = hex ? centre_y + place * hex_row<T> + half_hex_row<T> : spaced(centre_y, row, rows);
        for (std::int64_t column = 0; column < n; ++column) {
            const T x = spaced(centre_x, column, n);
            each(hex && row % 2 != 0 ? x + T(1) : x, y);
        }
    }
}

}  // namespace pelage
