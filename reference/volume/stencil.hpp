// The Laplacian of a whole volume where every cell diffuses at the same rate.
#pragma once

#include "core/space.hpp"

#include <vector>

namespace pelage::reference {

// The weighted sum of the neighbours less the cell's own share, for each cell, in whole numbers: divide by
// laplacian_divisor() of lattice/stencil.hpp for the Laplacian. Association: seven_point adds what five_point does in
// the cell's layer and what lies before and behind; twenty_seven_point adds sums of rows, then of layers.
template <class T>
void laplacian(const Volume&, const std::vector<T>& field, std::vector<T>& sums);

}  // namespace pelage::reference
