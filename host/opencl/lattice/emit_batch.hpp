// The part of a lattice's program by which one launch is of several lattices of one structure, a batch: all planes of
// the first one lie before those of the second, and so on, and each has numbers and a seed of its own. Work-items of
// one place in the third dimension are one lattice's; the list `members` says whose.
#pragma once

#include "core/experiment.hpp"
#include "core/lattice.hpp"
#include "opencl/rules/emit_rules.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace pelage {

// Numbers of one lattice in the buffer of parameters of a batch, `count` of them its own: the last two are its seed.
std::size_t batch_stride(std::size_t count);

// The fill of `//@ batch`. `mapping_buffers`: how the kernel names its planes of mappings.
std::string batch_text(const Experiment&, const LatticePlan&, const RuleText&,
                       const std::vector<std::string>& mapping_buffers);

}  // namespace pelage
