// Do a snapshot's arrays fit together?
#pragma once

#include "core/experiment.hpp"
#include "core/snapshot.hpp"

namespace pelage {

// Throws Error when an array has another length than there are cells, when there are not as many chemicals as the
// experiment defines, or when a lattice has another number of cells than columns x rows.
void check_shape(const Snapshot&, const Experiment&);

}  // namespace pelage
