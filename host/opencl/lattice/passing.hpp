// The values of a cell that pass through the levels of fused iterations.
#pragma once

#include "core/experiment.hpp"
#include "core/lattice.hpp"
#include "opencl/rules/emit_rules.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace pelage {

// A value of each cell that passes through the levels.
struct Passing {
    std::string buffer;     // the planes it lies in: conc, rate, polarity or mapping
    std::size_t plane = 0;  // its place among them
    std::string middle;     // pointer to the value in scratch whose neighbours are looked at; empty: they are not
    std::string result;     // the value to hand on
    bool written = true;    // else it need not be put back
};

// What passes through, those whose neighbours are looked at first.
std::vector<Passing> passing_fields(const Experiment&, const LatticePlan&, const RuleUse&);
std::size_t count_seen(const std::vector<Passing>&);

// Values of a cell that pass through the levels: concentrations, and rates, polarity and mappings that differ from
// cell to cell. `seen`: those whose neighbours are looked at one by one.
struct FusedFields {
    std::size_t all = 0;
    std::size_t seen = 0;
};
FusedFields fused_fields(const Experiment&, const LatticePlan&, const RuleUse&);

}  // namespace pelage
