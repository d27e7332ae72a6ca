// Why a lattice is carried out as it is, in words.
#pragma once

#include "core/experiment.hpp"
#include "core/lattice.hpp"
#include "core/tissue.hpp"
#include "opencl/rules/emit_rules.hpp"

#include <string>
#include <vector>

namespace pelage {

// Why it does not pay to stream iterations under these rules though they could be (Fusion::always), in words; empty
// when it pays on large lattices.
std::string why_not_streamed(const LatticePlan&, const RuleUse&);

// One sentence for each set of rules that act at the same time: from which iteration on, which rules, and whether its
// iterations are streamed on CPUs. Empty for free cells.
std::vector<std::string> explain_lattice(const Experiment&, const Snapshot& initial, Precision);

}  // namespace pelage
