// The numbers that a step of a lattice reads beside those of its rules.
#pragma once

#include "core/experiment.hpp"
#include "core/lattice.hpp"
#include "core/precision.hpp"
#include "opencl/rules/numbers.hpp"

#include <vector>

namespace pelage {

// In the order of LatticeParameter (emit_lattice.hpp). `rates`: of each chemical where it is that of every cell.
std::vector<KernelNumber> phase_numbers(const Experiment&, const LatticePlan&, const std::vector<double>& rates,
                                        const Phase&, Precision);

}  // namespace pelage
