// See far_tables.hpp.
#include "opencl/aggregate/far_tables.hpp"

#include "core/far_grid.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace pelage {

namespace {

using Nodes = std::array<double, far_nodes>;

Nodes nodes_between_0_and_1() {
    Nodes nodes{};
    for (std::size_t i = 0; i < nodes.size(); ++i)
        nodes[i] = 0.5 + 0.5 * std::cos((2.0 * static_cast<double>(i) + 1.0) / (2.0 * far_nodes) * std::numbers::pi);
    return nodes;
}

// Lagrange's polynomials at a place.
void append_basis(std::vector<float>& tables, const Nodes& nodes, double place) {
    for (const double own : nodes) {
        double value = 1.0;
        for (const double other : nodes) {
            if (other != own) value *= (place - other) / (own - other);
        }
        tables.push_back(static_cast<float>(value));
    }
}

}  // namespace

std::vector<float> far_tables(std::size_t leaf) {
    const Nodes nodes = nodes_between_0_and_1();
    std::vector<float> tables;
    for (std::size_t i = 0; i < far_coefficients; ++i) tables.push_back(static_cast<float>(nodes[i % far_nodes]));
    for (std::size_t i = 0; i < far_coefficients; ++i) tables.push_back(static_cast<float>(nodes[i / far_nodes]));
    for (const double half : {0.0, 0.5}) {
        for (const double node : nodes) append_basis(tables, nodes, half + 0.5 * node);
    }
    for (std::size_t i = 0; i < leaf; ++i)
        append_basis(tables, nodes, (static_cast<double>(i) + 0.5) / static_cast<double>(leaf));
    return tables;
}

}  // namespace pelage
