// How many neighbours each cell of a lattice or a volume has by its place.
#pragma once

#include "core/lattice.hpp"
#include "opencl/lattice/planes.hpp"

#include <cstdint>
#include <vector>

namespace pelage {

std::vector<std::int32_t> neighbour_counts(const LatticePlan&, const Grid&);

}  // namespace pelage
