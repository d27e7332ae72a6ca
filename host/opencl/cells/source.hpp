// The source of a step of free cells: kernels/cells/step.cl filled in for one experiment.
#pragma once

#include "core/experiment.hpp"
#include "core/rates.hpp"
#include "core/snapshot.hpp"
#include "core/tissue.hpp"
#include "opencl/cells/state.hpp"
#include "opencl/rules/numbers.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace pelage {

// What the emitted text depends on besides the rules.
struct CellsPlan {
    std::vector<RateKind> rates;  // one a chemical
    bool mirrors = false;         // some cells are mirror pairs
    bool all_listed = false;      // lists hold neighbours only, not candidates that may be too far

    bool operator==(const CellsPlan&) const = default;
};

CellsPlan cells_plan(const Experiment&, const Snapshot&, bool all_listed);

// Which arrays a step writes besides positions, concentrations and neighbour counts.
struct CellsWritten {
    bool rate = false;
    bool polarity = false;
    bool mapping = false;
};

// Positions, concentrations and counts always.
bool changes(const CellsWritten&, CellArray);

struct CellsSource {
    std::string text;
    CellsWritten written;
};

// What a step reads from its buffer of parameters: the seed, the phase's time step and bounds, the numbers of rules.
std::vector<KernelNumber> cells_parameters(const Experiment&, const Phase&, Precision);

enum class CellsForm { alone, together };  // one iteration a launch; many of a small tissue

// The rules in `active` act; with `test_intervals` only where their intervals say so. `phase` says which chemicals
// are bounded. `width`: cells a work-item handles side by side.
CellsSource cells_step_source(const Experiment&, const std::vector<bool>& active, bool test_intervals, const Phase&,
                              const CellsPlan&, Precision, std::size_t width, CellsForm);

}  // namespace pelage
