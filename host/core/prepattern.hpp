// From an experiment's `create`, `use` and `set` statements to the tissue's first state.
#pragma once

#include "core/experiment.hpp"
#include "core/precision.hpp"
#include "core/snapshot.hpp"

#include <cstddef>

namespace pelage {

// Draws position jitter (y before x), then polarity, then conc and diff of each chemical, cell by cell, as the
// published program does: in float, whatever the precision. What is not drawn has the precision of the run; expressions
// are computed in double precision, those of a `create` once its cells are there. Throws Error when a `set` names a
// cell that does not exist, when there are no cells, when a picture's shape is not the lattice's, or when an expression
// gives a rate below 0 or a concentration outside its bounds.
Snapshot initial_state(const Experiment&, Precision = Precision::single_);

std::size_t count_cells(const Experiment&);  // without creating them

}  // namespace pelage
