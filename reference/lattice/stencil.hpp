// The Laplacian of a whole field where every cell diffuses at the same rate.
#pragma once

#include "core/experiment.hpp"

#include <cstddef>
#include <vector>

namespace pelage::reference {

struct Shape {
    std::size_t columns = 0;
    std::size_t rows = 0;
    Boundary boundary = Boundary::no_flux;
    Stencil stencil = Stencil::nine_point;
};

// The weighted sum of the neighbours less the cell's own share, for each cell, in whole numbers: divide by
// laplacian_divisor() for the Laplacian. Association: sums of rows first, then of columns.
template <class T>
void laplacian(const Shape&, const std::vector<T>& field, std::vector<T>& sums);

// 6 for nine_point, 20 for sims, 1 for the others.
template <class T>
T laplacian_divisor(Stencil);

}  // namespace pelage::reference
