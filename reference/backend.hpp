// The reference: plain C++, one thread, written to be read beside the papers.
#pragma once

#include "core/neighbours.hpp"
#include "core/tissue.hpp"

#include <memory>

namespace pelage {

// Runs every valid experiment. In double it is the truth other results are judged by, in float their equal.
// The search and its settings concern free cells.
std::unique_ptr<Backend> reference_backend(Precision, NeighbourSearch = NeighbourSearch::kd_tree, SpatialSorting = {});

}  // namespace pelage
