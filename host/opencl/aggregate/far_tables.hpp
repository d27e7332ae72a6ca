// The numbers that kernels/aggregate/far_field.cl interpolates with.
#pragma once

#include <cstddef>
#include <vector>

namespace pelage {

// Nodes of the coefficients, those of x before those of y, between 0 and 1; the basis at the nodes of a block's lower
// and upper half; the basis at the columns of a leaf of so many.
std::vector<float> far_tables(std::size_t leaf);

}  // namespace pelage
