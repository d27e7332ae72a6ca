// Iterations of tiles in local memory; see kernels/lattice/tile.cl.
#pragma once

#include "opencl/lattice/fused_step.hpp"

#include <cstdint>
#include <vector>

namespace pelage {

class TiledStep final : public FusedStep {
public:
    TiledStep(const Session&, const Experiment&, const LatticePlan&, const std::vector<bool>& active,
              bool test_intervals, Choice);

private:
    FusedLaunch next_launch(const Grid&, std::uint64_t count) const override;
    void add_more(Arguments&, const FusedLaunch&, const cl::Buffer&) override {}
};

}  // namespace pelage
