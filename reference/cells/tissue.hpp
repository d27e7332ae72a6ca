// Free cells on the reference: rules, diffusion, collision and division, one cell after the other in order of id.
#pragma once

#include "core/neighbours.hpp"
#include "core/tissue.hpp"

#include <memory>

namespace pelage {

// One iteration (Malheiros & Walter 2017, as their program does it, neighbours in ascending id): rules; for every cell
// nearer than 3 diffusion, gradient and collision; `set` and bounds; mirror pairs; divisions. `bins` and `kd_tree` both
// mean the exact search. A state does not hold the matrix of spatial sorting: from a state read back that search starts
// again in order of id. Throws Error for a lattice, for a window that is not offered and, while advancing, when a
// division passes largest_cell_count.
std::unique_ptr<Tissue> make_reference_cells(std::shared_ptr<const Experiment>, const Snapshot& initial, Precision,
                                             NeighbourSearch = NeighbourSearch::kd_tree, SpatialSorting = {});

}  // namespace pelage
