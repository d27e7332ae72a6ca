// Growth of a lattice by duplicating one element of every row or column.
#pragma once

#include "core/growth.hpp"
#include "reference/rules/state.hpp"

#include <cstddef>
#include <cstdint>

namespace pelage::reference {

// Every field grows alike: elements up to the pick stay, the pick is duplicated behind itself, the rest shift by one.
// The duplicate alone is born in `iteration`. Positions are laid out anew around the lattice's centre.
template <class T>
void expand_state(State<T>&, const Insertion&, std::uint64_t iteration);

// Gives the state another size, and its cells the places that belong to it.
template <class T>
void lay_out(State<T>&, std::size_t columns, std::size_t rows);

}  // namespace pelage::reference
