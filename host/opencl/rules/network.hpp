// The weights of a neural reaction as kernels/rules/neural.cl reads them.
#pragma once

#include "core/neural.hpp"

#include <vector>

namespace pelage {

std::vector<double> network_table(const Network&);

}  // namespace pelage
