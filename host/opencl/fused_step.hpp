// Several iterations in one pass over memory, streamed (kernels/lattice_stream.cl) or in tiles
// (kernels/lattice_tile.cl), under any set of rules.
#pragma once

#include "opencl/fused_cut.hpp"
#include "opencl/lattice_step.hpp"
#include "opencl/shared_steps.hpp"

#include <cstdint>
#include <vector>

namespace pelage {

class FusedStep final : public LatticeKernel {
public:
    FusedStep(const Session&, const Experiment&, const LatticePlan&, const std::vector<bool>& active,
              bool test_intervals, bool tiled);

    void enqueue(LatticeState&, const cl::Buffer& parameters, std::uint64_t first, std::uint64_t count, Pace&) override;
    std::string describe() const override;

private:
    void set_planes(LatticeState&);
    void set_sharing(const cl::Buffer& none, const FusedLaunch&);
    void swap_planes(LatticeState&) const;

    const Session& session_;
    std::size_t width_;
    FusedShape shape_;
    std::uint64_t seed_;
    bool tiled_;
    SharedSteps shared_;
    bool writes_rates_ = false;
    bool writes_polarity_ = false;
    bool writes_mappings_ = false;
    cl::Kernel kernel_;
};

}  // namespace pelage
