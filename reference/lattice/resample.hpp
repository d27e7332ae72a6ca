// Growth of a lattice by interpolation.
#pragma once

#include "core/resampling.hpp"
#include "reference/rules/state.hpp"

#include <vector>

namespace pelage::reference {

// Concentrations are interpolated and stay within their bounds, one a chemical; all else is that of the nearest old
// element. Positions are laid out anew around the lattice's centre.
template <class T>
void resample_state(State<T>&, const Resampling&, const std::vector<Bounds>&);

}  // namespace pelage::reference
