// Growth of a lattice by duplicating one element of every row or column.
#pragma once

#include "core/growth.hpp"
#include "reference/state.hpp"

namespace pelage::reference {

// Every field grows alike: elements up to the pick stay, the pick is duplicated behind itself, the rest shift by one.
// Positions are laid out anew around the lattice's centre.
template <class T>
void expand_state(State<T>&, const Insertion&);

}  // namespace pelage::reference
