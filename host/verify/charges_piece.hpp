// Charges of a piece of a lattice that the self-test of a run grows.
#pragma once

#include "core/experiment.hpp"
#include "core/snapshot.hpp"

namespace pelage::verify {

// Puts the piece's charges right: they have no potentials yet, lie where the experiment lets them, and one does in the
// middle or on the next open site where there were none. Where no site of the piece is open, the experiment leaves its
// sites all open.
void give_charges(Experiment&, Snapshot& piece);

}  // namespace pelage::verify
