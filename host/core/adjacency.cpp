// See adjacency.hpp.
#include "core/adjacency.hpp"

namespace pelage {

namespace {

// The entry for the neighbour of (column, row) in that direction, if there is one.
void add(LatticeAdjacency& made, const Lattice& lattice, std::size_t column, std::size_t row, Direction to) {
    const bool diagonal = to.up != 0 && to.right != 0;
    if ((to.up == 0 && to.right == 0) || (lattice.stencil == Stencil::five_point && diagonal)) return;
    const auto there = place_along(row, to.up, lattice.rows, lattice.boundary);
    const auto across = place_along(column, to.right, lattice.columns, lattice.boundary);
    const bool outside = !there || !across;
    if (outside && lattice.boundary != Boundary::absorbing) return;
    made.indices.push_back(outside ? Adjacency::nobody
                                   : static_cast<std::uint32_t>(*there * lattice.columns + *across));
    made.weights.push_back(neighbour_share(lattice, to));
    made.directions.push_back(to);
}

// Calls visit(direction) for each neighbour that the stencil has, in order.
template <class Visit>
void each_direction(const Volume& volume, Visit&& visit) {
    for (int deep = -1; deep <= 1; ++deep) {
        for (int up = -1; up <= 1; ++up) {
            for (int right = -1; right <= 1; ++right) {
                const Direction to = direction(right, up, deep);
                if (neighbour_share(volume, to) != 0.0) visit(to);
            }
        }
    }
}

void add(LatticeAdjacency& made, const Volume& volume, std::size_t cell, Direction to) {
    const std::size_t line = cell / volume.columns;
    const auto across = place_along(cell % volume.columns, to.right, volume.columns, volume.boundary);
    const auto row = place_along(line % volume.rows, to.up, volume.rows, volume.boundary);
    const auto layer = place_along(line / volume.rows, to.deep, volume.layers, volume.boundary);
    const bool outside = !across || !row || !layer;
    if (outside && volume.boundary != Boundary::absorbing) return;
    made.indices.push_back(outside
                               ? Adjacency::nobody
                               : static_cast<std::uint32_t>((*layer * volume.rows + *row) * volume.columns + *across));
    made.weights.push_back(neighbour_share(volume, to));
    made.directions.push_back(to);
}

}  // namespace

double neighbour_share(const Lattice& lattice, Direction to) {
    const bool diagonal = to.up != 0 && to.right != 0;
    switch (lattice.stencil) {
        case Stencil::own: {
            const int reach = lattice.reach();
            return lattice.weights[static_cast<std::size_t>((2 * reach + 1) * (reach - to.up) + reach + to.right)];
        }
        case Stencil::nine_point:
            return diagonal ? 1.0 / 6 : 4.0 / 6;
        case Stencil::sims:
            return diagonal ? 0.05 : 0.2;
        default:
            return 1.0;
    }
}

double neighbour_share(const Volume& volume, Direction to) {
    const int away = (to.right != 0 ? 1 : 0) + (to.up != 0 ? 1 : 0) + (to.deep != 0 ? 1 : 0);
    if (away == 0) return 0.0;
    if (volume.stencil == Stencil::seven_point) return away == 1 ? 1.0 : 0.0;
    return (away == 1 ? 14.0 : away == 2 ? 3.0 : 1.0) / 30;
}

std::vector<int> row_order(const Lattice& lattice, std::size_t row) {
    if (lattice.arithmetic == Arithmetic::published && lattice.boundary != Boundary::wrap) {
        if (row == 0) return {1, 0};
        if (row + 1 == lattice.rows) return {0, -1};
    }
    if (lattice.reach() == 2) return {-2, -1, 0, 1, 2};
    return {-1, 0, 1};
}

LatticeAdjacency lattice_adjacency(const Lattice& lattice) {
    LatticeAdjacency made;
    const int reach = lattice.reach();
    for (std::size_t row = 0; row < lattice.rows; ++row) {
        const std::vector<int> order = row_order(lattice, row);
        for (std::size_t column = 0; column < lattice.columns; ++column) {
            for (const int up : order) {
                for (int right = -reach; right <= reach; ++right) {
                    add(made, lattice, column, row, direction(right, up));
                }
            }
            made.offsets.push_back(made.indices.size());
        }
    }
    return made;
}

LatticeAdjacency volume_adjacency(const Volume& volume) {
    LatticeAdjacency made;
    const std::size_t cells = volume.columns * volume.rows * volume.layers;
    for (std::size_t cell = 0; cell < cells; ++cell) {
        each_direction(volume, [&](Direction to) { add(made, volume, cell, to); });
        made.offsets.push_back(made.indices.size());
    }
    return made;
}

}  // namespace pelage
