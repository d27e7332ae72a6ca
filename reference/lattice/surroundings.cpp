// See surroundings.hpp.
#include "reference/lattice/surroundings.hpp"

#include <optional>

namespace pelage::reference {

namespace {

// The place `offset` further along a line of `count` places; empty beyond an edge.
std::optional<std::size_t> step(std::size_t place, int offset, std::size_t count, Boundary boundary) {
    if (offset == 0) return place;
    const bool leaves = offset < 0 ? place == 0 : place + 1 == count;
    if (!leaves) return offset < 0 ? place - 1 : place + 1;
    if (boundary != Boundary::wrap) return std::nullopt;
    return offset < 0 ? count - 1 : 0;
}

}  // namespace

std::vector<int> row_order(const Shape& shape, Arithmetic arithmetic, std::size_t row) {
    if (arithmetic == Arithmetic::published && shape.boundary != Boundary::wrap) {
        if (row == 0) return {1, 0};
        if (row + 1 == shape.rows) return {0, -1};
    }
    return {-1, 0, 1};
}

Surroundings surroundings(const Shape& shape, Arithmetic arithmetic) {
    Surroundings result;
    result.first.push_back(0);
    for (std::size_t row = 0; row < shape.rows; ++row) {
        const std::vector<int> order = row_order(shape, arithmetic, row);
        for (std::size_t column = 0; column < shape.columns; ++column) {
            for (const int up : order) {
                for (int right = -1; right <= 1; ++right) {
                    if (up == 0 && right == 0) continue;
                    if (shape.stencil == Stencil::five_point && up != 0 && right != 0) continue;
                    const auto there = step(row, up, shape.rows, shape.boundary);
                    const auto across = step(column, right, shape.columns, shape.boundary);
                    const bool outside = !there || !across;
                    if (outside && shape.boundary != Boundary::absorbing) continue;
                    const std::size_t cell = outside ? row * shape.columns + column : *there * shape.columns + *across;
                    result.list.push_back({static_cast<std::uint32_t>(cell), static_cast<std::int8_t>(right),
                                           static_cast<std::int8_t>(up), outside});
                }
            }
            result.first.push_back(result.list.size());
        }
    }
    return result;
}

}  // namespace pelage::reference
