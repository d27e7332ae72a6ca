// The Laplacian of a whole field where every cell diffuses at the same rate.
#pragma once

#include "core/space.hpp"

#include <cstddef>
#include <vector>

namespace pelage::reference {

// The weighted sum of the neighbours less the cell's own share, for each cell, in whole numbers: divide by
// laplacian_divisor() for the Laplacian. Association: sums of rows first, then of columns.
template <class T>
void laplacian(const Lattice&, const std::vector<T>& field, std::vector<T>& sums);

// 6 for nine_point, 20 for sims, 30 for twenty_seven_point, 1 for the others.
template <class T>
T laplacian_divisor(Stencil);

}  // namespace pelage::reference
