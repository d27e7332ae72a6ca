// How a lattice's iterations are carried out, in which cut, and why: a pure function of the device, of what the rules
// ask for and of the work to be done. A run, --explain, the self-test and the tuner all ask it; it calls no OpenCL.
#pragma once

#include "core/experiment.hpp"
#include "core/lattice.hpp"
#include "opencl/device/device.hpp"
#include "opencl/device/options.hpp"
#include "opencl/lattice/emit_fused.hpp"
#include "opencl/lattice/passing.hpp"
#include "opencl/rules/emit_rules.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pelage {

// What one set of active rules asks of a lattice's kernels.
struct RuleNeeds {
    bool networks = false;      // neural reactions
    bool draws = false;         // random numbers
    bool polarizes = false;     // polarities follow gradients
    bool uneven_rates = false;  // diffusion rates differ between cells
    bool wide = false;          // cells are read that are not beside: fused iterations have no such margins
    bool volume = false;        // of layers: stepped, or streamed through the layers by kernels/volume/step.cl
    FusedFields fields;
};
RuleNeeds rule_needs(const Experiment&, const LatticePlan&, const RuleUse&);

// What is to be done under one set of active rules.
struct Work {
    double cells = 0;
    double bytes_a_cell = 0;      // that a step reads and writes
    double done = 0;              // cell-updates until now, with those that are asked for now
    std::optional<double> ahead;  // cell-updates from now on; none where nobody can tell: the experiment is at its end
    bool compiled = false;        // a streamed program for these rules is there
};

// Bytes that a step reads and writes a cell, of all that rules may change at any time. `every`: what all rules use.
double bytes_a_cell(const Experiment&, const LatticePlan&, const RuleUse& every, Precision);

// Cell-updates that lie ahead of `cells` under the rules active at `iteration`.
std::optional<double> work_ahead(const Experiment&, const std::vector<bool>& active, std::uint64_t iteration,
                                 double cells);

// A whole run's work under the rules active at `iteration`, at the size that the lattice has in the end; at least
// `cells`.
Work foreseen_work(const Experiment&, const std::vector<bool>& active, std::uint64_t iteration, double cells,
                   double bytes_a_cell);

struct Choice {
    Path path = Path::step;  // never automatic
    std::size_t width = 1;   // cells that a work-item handles side by side
    FusedShape cut;          // of one launch; of `shared` and `step` the group alone counts
    std::string why;

    std::string text() const;  // "streamed, up to 16 iterations in one pass over memory; ..."
};

// Automatic runs are streamed only after so many cell-updates: a streamed program takes seconds to compile.
inline constexpr double streamed_after = 2e8;

// Throws Error when what the options ask for does not fit into the device's local memory.
Choice choose(const DeviceInfo&, const RuleNeeds&, const Work&, const OpenclOptions&);

// The same for a batch (batch.hpp): it is stepped or tiled, by launches that are of all its lattices. `work`: of all of
// them.
Choice choose_for_batch(const DeviceInfo&, const RuleNeeds&, const Work&, const OpenclOptions&);

// Numbers side by side in the device's vectors: 1, 2, 4, 8 or 16.
std::size_t vector_lanes(const DeviceInfo&, Precision);

// Cells that a work-item handles side by side: the lanes of a processor, 1 on other devices.
std::size_t lattice_width(const DeviceInfo&, const OpenclOptions&);

}  // namespace pelage
