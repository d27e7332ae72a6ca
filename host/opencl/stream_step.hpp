// Several iterations a pass over memory (kernels/lattice_stream.cl), under any set of rules.
#pragma once

#include "opencl/emit_stream.hpp"
#include "opencl/lattice_step.hpp"

#include <cstdint>
#include <vector>

namespace pelage {

// How a stretch of iterations is cut into launches.
struct StreamLaunch {
    std::size_t steps = 1;    // levels of a pass
    std::size_t passes = 1;   // of one launch
    std::size_t vectors = 1;  // across a band
    std::size_t bands = 1;    // work-groups along a row
    std::size_t strip = 1;    // rows of a work-group
    std::size_t strips = 1;   // work-groups up the columns
};

StreamShape stream_shape(const Session&, const StreamFields&, std::size_t width);
StreamLaunch stream_launch(const Session&, const Grid&, const StreamShape&, std::size_t width, std::uint64_t count);

class StreamStep final : public LatticeKernel {
public:
    StreamStep(const Session&, const Experiment&, const LatticePlan&, const std::vector<bool>& active,
               bool test_intervals);

    void enqueue(LatticeState&, const cl::Buffer& parameters, std::uint64_t first, std::uint64_t count, Pace&) override;
    std::string describe() const override;

private:
    void set_planes(LatticeState&);
    void swap_planes(LatticeState&) const;

    const Session& session_;
    std::size_t width_;
    StreamShape shape_;
    std::uint64_t seed_;
    bool writes_rates_ = false;
    bool writes_polarity_ = false;
    bool writes_mappings_ = false;
    cl::Kernel kernel_;
};

}  // namespace pelage
