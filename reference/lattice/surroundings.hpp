// Who is whose neighbour on a lattice, and in which order they are taken.
#pragma once

#include "core/lattice.hpp"
#include "reference/lattice/stencil.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pelage::reference {

struct Neighbour {
    std::uint32_t cell = 0;  // the cell's own id where `outside`
    std::int8_t right = 0;   // -1, 0 or 1: from the cell to the neighbour
    std::int8_t up = 0;
    bool outside = false;  // beyond an absorbing edge: concentrations of 0
};

// The order in which a row takes the rows around it, as offsets of -1, 0, 1: from below upwards; but the published
// program takes its own row last in the bottom row and first in the top row of a grid that is not closed to a torus.
std::vector<int> row_order(const Shape&, Arithmetic, std::size_t row);

// Neighbours of cell i: list[first[i]] .. list[first[i + 1] - 1]. Outside neighbours are absent under no_flux.
struct Surroundings {
    std::vector<std::size_t> first;
    std::vector<Neighbour> list;

    std::int32_t count(std::size_t cell) const { return static_cast<std::int32_t>(first[cell + 1] - first[cell]); }
};

Surroundings surroundings(const Shape&, Arithmetic);

}  // namespace pelage::reference
