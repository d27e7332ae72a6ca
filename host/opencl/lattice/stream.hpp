// Iterations streamed through a processor's caches; see kernels/lattice/stream.cl.
#pragma once

#include "opencl/lattice/fused_step.hpp"
#include "opencl/lattice/shared_steps.hpp"

#include <cstdint>
#include <vector>

namespace pelage {

class StreamedStep final : public FusedStep {
public:
    StreamedStep(const Session&, const Experiment&, const LatticePlan&, const std::vector<bool>& active,
                 bool test_intervals, Choice);

private:
    FusedLaunch next_launch(const Grid&, std::uint64_t count) const override;
    void add_more(Arguments&, const FusedLaunch&, const cl::Buffer& parameters) override;

    SharedSteps shared_;
};

}  // namespace pelage
