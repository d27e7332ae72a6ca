// See far_field.hpp.
#include "reference/aggregate/far_field.hpp"

#include "core/inverse_root.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <utility>

namespace pelage::reference {

namespace {

// Of Chebyshev, between 0 and 1.
double node(std::size_t i) {
    const double angle = static_cast<double>(2 * i + 1) / static_cast<double>(2 * far_nodes) * std::numbers::pi;
    return 0.5 + 0.5 * std::cos(angle);
}

bool beside(std::int32_t a, std::int32_t b) { return std::abs(a - b) <= 1; }

}  // namespace

FarBasis far_basis(double place) {
    FarBasis basis{};
    for (std::size_t i = 0; i < far_nodes; ++i) {
        double product = 1.0;
        for (std::size_t j = 0; j < far_nodes; ++j) {
            if (j != i) product *= (place - node(j)) / (node(i) - node(j));
        }
        basis[i] = static_cast<float>(product);
    }
    return basis;
}

FarField::FarField(FarGrid grid) : grid_(std::move(grid)), sums_(grid_.blocks()) {
    for (std::size_t i = 0; i < far_nodes; ++i) nodes_[i] = static_cast<float>(node(i));
    for (std::size_t half = 0; half < 2; ++half) {
        for (std::size_t i = 0; i < far_nodes; ++i)
            halves_[half][i] = far_basis(0.5 * (static_cast<double>(half) + node(i)));
    }
    const auto side = static_cast<double>(grid_.levels.front().side);
    for (double place = 0.5; place < side; place += 1.0) places_.push_back(far_basis(place / side));
}

void FarField::add_to(std::size_t level, std::int32_t column, std::int32_t row, const FarCharge& charge) {
    const FarLevel& cut = grid_.levels[level];
    const auto side = static_cast<std::int32_t>(cut.side);
    auto& sums = sums_[cut.first + static_cast<std::size_t>(row) * cut.columns + static_cast<std::size_t>(column)];
    const auto away = [&](std::int32_t first, std::int32_t other, std::size_t i) {
        const float inside = static_cast<float>(side) * nodes_[i] - 0.5f;
        return static_cast<float>(first - other) + inside;
    };
    for (std::size_t i = 0; i < far_coefficients; ++i) {
        const float x = away(column * side, charge.x, i % far_nodes), y = away(row * side, charge.y, i / far_nodes);
        sums[i] += inverse_parts_at(x * x + y * y, charge.size);
    }
}

void FarField::add(const FarCharge& charge) {
    for (std::size_t level = 0; level < grid_.levels.size(); ++level) {
        const FarLevel& cut = grid_.levels[level];
        const auto side = static_cast<std::int32_t>(cut.side);
        const std::int32_t x = charge.x / side, y = charge.y / side;
        for (std::int32_t row = 0; row < static_cast<std::int32_t>(cut.rows); ++row) {
            if (!beside(row / 2, y / 2)) continue;
            for (std::int32_t column = 0; column < static_cast<std::int32_t>(cut.columns); ++column) {
                if (!beside(column / 2, x / 2) || (beside(column, x) && beside(row, y))) continue;
                add_to(level, column, row, charge);
            }
        }
    }
}

// Each level's sums, interpolated at the nodes of the smaller block that the way down leads to.
FarField::Values FarField::at_nodes_of_leaf(std::size_t column, std::size_t row) const {
    Values values{};
    for (std::size_t level = grid_.levels.size(); level-- > 0;) {
        const FarLevel& cut = grid_.levels[level];
        const std::size_t x = column >> level, y = row >> level;
        Values inner{}, outer{};
        const auto& across = halves_[x % 2];
        const auto& along = halves_[y % 2];
        for (std::size_t i = 0; i < far_coefficients; ++i) {
            for (std::size_t j = 0; j < far_nodes; ++j)
                inner[i] += across[i % far_nodes][j] * values[i / far_nodes * far_nodes + j];
        }
        for (std::size_t i = 0; i < far_coefficients; ++i) {
            for (std::size_t j = 0; j < far_nodes; ++j)
                outer[i] += along[i / far_nodes][j] * inner[j * far_nodes + i % far_nodes];
        }
        const auto& sums = sums_[cut.first + y * cut.columns + x];
        for (std::size_t i = 0; i < far_coefficients; ++i) values[i] = outer[i] + static_cast<float>(sums[i]);
    }
    return values;
}

std::int64_t FarField::at(std::int32_t x, std::int32_t y) const {
    const std::size_t side = grid_.levels.front().side;
    const auto column = static_cast<std::size_t>(x), row = static_cast<std::size_t>(y);
    const Values values = at_nodes_of_leaf(column / side, row / side);
    const FarBasis& across = places_[column % side];
    const FarBasis& along = places_[row % side];
    float sum = 0.0f;
    for (std::size_t k = 0; k < far_nodes; ++k) {
        float of_row = 0.0f;
        for (std::size_t j = 0; j < far_nodes; ++j) of_row += across[j] * values[k * far_nodes + j];
        sum += along[k] * of_row;
    }
    return static_cast<std::int64_t>(sum);
}

}  // namespace pelage::reference
