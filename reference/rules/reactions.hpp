// Adds a reaction to the new concentrations.
#pragma once

#include "core/lattice.hpp"
#include "reference/rules/operands.hpp"

#include <cstdint>
#include <vector>

namespace pelage::reference {

// For each cell where truth holds: new += scale * f(species) * dt with the old species, in the order of operations of
// `arithmetic`.
template <class T>
void react_cells(const React&, Arithmetic, T dt, Sight<T>&, State<T>& next, const std::vector<std::uint8_t>& truth);

}  // namespace pelage::reference
