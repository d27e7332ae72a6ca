// Several iterations in one pass over memory, streamed (kernels/lattice/stream.cl) or in tiles
// (kernels/lattice/tile.cl), under any set of rules.
#pragma once

#include "opencl/lattice/fused_cut.hpp"
#include "opencl/lattice/shared_steps.hpp"
#include "opencl/lattice/step.hpp"

#include <cstdint>
#include <vector>

namespace pelage {

class FusedStep final : public LatticeKernel {
public:
    FusedStep(const Session&, const Experiment&, const LatticePlan&, const std::vector<bool>& active,
              bool test_intervals, Choice);

    void enqueue(LatticeState&, const cl::Buffer& parameters, std::uint64_t first, std::uint64_t count, Pace&) override;

private:
    void set_arguments(LatticeState&, const cl::Buffer& parameters, const FusedLaunch&, std::uint64_t first);
    void swap_planes(LatticeState&) const;

    const Session& session_;
    Choice choice_;
    std::uint64_t seed_;
    bool tiled_;
    SharedSteps shared_;
    bool writes_rates_ = false;
    bool writes_polarity_ = false;
    bool writes_mappings_ = false;
    cl::Kernel kernel_;
};

}  // namespace pelage
