// See features.hpp.
#include "stats/features.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <optional>
#include <vector>

namespace pelage::stats {

void check(const Grid& grid) {
    if (grid.columns == 0 || grid.rows == 0 || grid.values.size() / grid.columns != grid.rows ||
        grid.values.size() % grid.columns != 0)
        throw Error(fmt::format("{} values are no pattern of {} x {}", grid.values.size(), grid.columns, grid.rows));
    if (!std::ranges::all_of(grid.values, [](double value) { return std::isfinite(value); }))
        throw Error("a pattern that is measured holds finite numbers alone");
}

namespace {

std::optional<std::size_t> moved(std::size_t place, int by, std::size_t count, bool wrap) {
    if (by == 0) return place;
    if (by > 0 ? place + 1 < count : place > 0) return by > 0 ? place + 1 : place - 1;
    if (!wrap) return std::nullopt;
    return by > 0 ? 0 : count - 1;
}

std::optional<std::size_t> neighbour(const Grid& grid, std::size_t cell, int right, int up) {
    const auto column = moved(cell % grid.columns, right, grid.columns, grid.wrap);
    const auto row = moved(cell / grid.columns, up, grid.rows, grid.wrap);
    if (!column || !row) return std::nullopt;
    return *row * grid.columns + *column;
}

// Takes the piece that the cell belongs to out of what is inside.
void remove_piece(const Grid& grid, std::vector<bool>& inside, std::size_t cell, std::vector<std::size_t>& open) {
    open.assign(1, cell);
    inside[cell] = false;
    while (!open.empty()) {
        const std::size_t at = open.back();
        open.pop_back();
        for (const auto& [right, up] : {std::array{1, 0}, std::array{-1, 0}, std::array{0, 1}, std::array{0, -1}}) {
            const auto next = neighbour(grid, at, right, up);
            if (!next || !inside[*next]) continue;
            inside[*next] = false;
            open.push_back(*next);
        }
    }
}

}  // namespace

Features features_of(const Grid& grid) {
    check(grid);
    const auto [low, high] = std::minmax_element(grid.values.begin(), grid.values.end());
    const double middle = *low + (*high - *low) / 2.0;
    std::vector<bool> inside(grid.values.size());
    std::size_t cells = 0;
    for (std::size_t cell = 0; cell < inside.size(); ++cell) {
        inside[cell] = grid.values[cell] > middle;
        cells += inside[cell] ? 1 : 0;
    }
    Features features;
    std::vector<std::size_t> open;
    for (std::size_t cell = 0; cell < inside.size(); ++cell) {
        if (!inside[cell]) continue;
        ++features.count;
        remove_piece(grid, inside, cell, open);
    }
    features.coverage = static_cast<double>(cells) / static_cast<double>(inside.size());
    if (features.count > 0) features.size = static_cast<double>(cells) / static_cast<double>(features.count);
    return features;
}

double orientation_order(const Grid& grid) {
    check(grid);
    std::complex<double> turned = 0.0;
    double total = 0.0;
    const auto slope = [&](std::size_t cell, int right, int up) {
        const std::size_t before = neighbour(grid, cell, -right, -up).value_or(cell);
        const std::size_t behind = neighbour(grid, cell, right, up).value_or(cell);
        return 0.5 * (grid.values[behind] - grid.values[before]);
    };
    for (std::size_t cell = 0; cell < grid.values.size(); ++cell) {
        const std::complex<double> gradient{slope(cell, 1, 0), slope(cell, 0, 1)};
        turned += gradient * gradient;
        total += std::norm(gradient);
    }
    return total > 0.0 ? std::abs(turned) / total : 0.0;
}

}  // namespace pelage::stats
