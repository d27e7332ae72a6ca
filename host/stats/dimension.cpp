// See dimension.hpp.
#include "stats/dimension.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace pelage::stats {

namespace {

struct Cell {
    std::size_t column = 0, row = 0;
};

// Counted from the corner of what they span.
std::vector<Cell> cells_above(const Grid& grid) {
    const auto [low, high] = std::minmax_element(grid.values.begin(), grid.values.end());
    const double middle = *low + (*high - *low) / 2.0;
    std::vector<Cell> cells;
    Cell corner{grid.columns, grid.rows};
    for (std::size_t cell = 0; cell < grid.values.size(); ++cell) {
        if (!(grid.values[cell] > middle)) continue;
        cells.push_back({cell % grid.columns, cell / grid.columns});
        corner = {std::min(corner.column, cells.back().column), std::min(corner.row, cells.back().row)};
    }
    for (Cell& cell : cells) cell = {cell.column - corner.column, cell.row - corner.row};
    return cells;
}

std::size_t span_of(const std::vector<Cell>& cells) {
    std::size_t span = 0;
    for (const Cell& cell : cells) span = std::max({span, cell.column + 1, cell.row + 1});
    return span;
}

std::size_t boxes(const std::vector<Cell>& cells, std::size_t side, std::size_t span) {
    const std::size_t across = (span + side - 1) / side;
    std::vector<bool> hit(across * across);
    for (const Cell& cell : cells) hit[cell.row / side * across + cell.column / side] = true;
    return static_cast<std::size_t>(std::count(hit.begin(), hit.end(), true));
}

}  // namespace

double dimension_of(const Grid& grid) {
    check(grid);
    const std::vector<Cell> cells = cells_above(grid);
    const std::size_t span = span_of(cells);
    double count = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
    for (std::size_t side = 2; 4 * side <= span; side *= 2) {
        const double size = -std::log(static_cast<double>(side));
        const double number = std::log(static_cast<double>(boxes(cells, side, span)));
        count += 1.0;
        x += size;
        y += number;
        xx += size * size;
        xy += size * number;
    }
    return count < 2.0 ? 0.0 : (count * xy - x * y) / (count * xx - x * x);
}

}  // namespace pelage::stats
