// Who is whose neighbour, with which weight: one form for every space, compressed rows.
#pragma once

#include "core/space.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace pelage {

// The neighbours of cell i are the entries offsets[i] .. offsets[i + 1] - 1, in the order in which they are taken.
struct Adjacency {
    static constexpr std::uint32_t nobody =
        0xffffffff;  // beyond an absorbing edge: amounts of 0, at the cell's own rate

    std::vector<std::size_t> offsets{0};
    std::vector<std::uint32_t> indices;  // of the neighbour, or nobody
    std::vector<double> weights;         // the neighbour's share of an exchange

    std::size_t cells() const { return offsets.size() - 1; }
    std::size_t count(std::size_t cell) const { return offsets[cell + 1] - offsets[cell]; }
};

// From a cell of a lattice to its neighbour: -1, 0 or 1 each, or up to 2 where the stencil reaches so far.
struct Direction {
    std::int8_t right = 0;
    std::int8_t up = 0;
    std::int8_t deep = 0;  // layers of a volume: -1, 0 or 1
};
constexpr Direction direction(int right, int up, int deep = 0) {
    return {static_cast<std::int8_t>(right), static_cast<std::int8_t>(up), static_cast<std::int8_t>(deep)};
}
constexpr bool is_beside(Direction to) { return to.right >= -1 && to.right <= 1 && to.up >= -1 && to.up <= 1; }

// A neighbour's weight in the stencil; five_point has no diagonal ones, seven_point those at faces alone.
double neighbour_share(const Lattice&, Direction);
double neighbour_share(const Volume&, Direction);

struct LatticeAdjacency : Adjacency {
    std::vector<Direction> directions;  // one an entry
};

// The eight neighbours of each cell, four under five_point, or 24 under 25 weights of one's own; beyond an edge that
// lets nothing through there is none.
LatticeAdjacency lattice_adjacency(const Lattice&);
// From the layer before to the one behind, in each from the row below to the one above, in each from left to right.
LatticeAdjacency volume_adjacency(const Volume&);

// The place `offset` further along a line of `count` places; empty beyond an edge.
inline std::optional<std::size_t> place_along(std::size_t place, int offset, std::size_t count, Boundary boundary) {
    const auto length = static_cast<std::int64_t>(count);
    const std::int64_t there = static_cast<std::int64_t>(place) + offset;
    if (there >= 0 && there < length) return static_cast<std::size_t>(there);
    if (boundary != Boundary::wrap) return std::nullopt;
    return static_cast<std::size_t>((there % length + length) % length);
}

// The same where an edge that lets nothing through repeats its place; empty beyond an absorbing edge.
inline std::optional<std::size_t> place_repeated(std::size_t place, int offset, std::size_t count, Boundary boundary) {
    const auto there = place_along(place, offset, count, boundary);
    if (there || boundary != Boundary::no_flux) return there;
    return offset < 0 ? 0 : count - 1;
}

// The order in which a row takes the rows around it, as offsets -1, 0, 1 or -2 to 2: from below upwards; but the
// published program takes its own row last in the bottom row and first in the top row of a grid that is not closed to a
// torus.
std::vector<int> row_order(const Lattice&, std::size_t row);

}  // namespace pelage
