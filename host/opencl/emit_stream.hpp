// The source of several fused iterations of a lattice (kernels/lattice_stream.cl) for one set of active rules.
#pragma once

#include "core/experiment.hpp"
#include "core/lattice.hpp"
#include "opencl/emit_rules.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace pelage {

// How a program of fused iterations is cut to a device.
struct StreamShape {
    std::size_t depth = 16;    // most iterations a launch
    std::size_t block = 8;     // rows taken at a time
    std::size_t vectors = 18;  // most vectors across a band
    std::size_t group = 1;     // work-items
};

// Why these rules cannot be fused, in words; empty when they can. Fused programs hold concentrations alone: rates are
// the same in all cells, and no state of a cell but its concentrations outlasts an iteration.
std::string why_not_fused(const LatticePlan&, const RuleUse&);

std::string stream_source(const Experiment&, const LatticePlan&, const RuleText&, const std::vector<bool>& bounded,
                          std::size_t width, const StreamShape&);

}  // namespace pelage
