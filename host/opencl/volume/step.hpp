// The kernel that carries out iterations of a volume under one set of active rules.
#pragma once

#include "opencl/lattice/step.hpp"
#include "opencl/volume/cuts.hpp"

#include <cstdint>
#include <vector>

namespace pelage {

// How a launch is cut; see kernels/volume/step.cl.
struct VolumeShape {
    std::size_t across = 1;      // work-items along a row
    std::size_t strips = 1;      // of rows
    std::size_t deep = 1;        // work-items along z
    std::size_t work_group = 1;  // along a row
    std::size_t steps = 1;       // iterations of a launch
};

// `count`: iterations to come. More than one step of a launch where the choice is `streamed` and the sides allow it.
VolumeShape volume_shape(const DeviceInfo&, const Choice&, const Volume&, std::uint64_t count);

class VolumeStep final : public LatticeKernel {
public:
    // See LatticeStep.
    VolumeStep(const Session&, const Experiment&, const LatticePlan&, const std::vector<bool>& active,
               bool test_intervals, const Choice&);

    void enqueue(LatticeState&, const cl::Buffer& parameters, std::uint64_t first, std::uint64_t count, Pace&) override;

private:
    // The strips, then what lies between them.
    void launch(LatticeState&, const cl::Buffer& parameters, const VolumeShape&, std::uint64_t first);
    void launch_timed(LatticeState&, const cl::Buffer& parameters, const VolumeShape&, std::uint64_t first);

    const Session& session_;
    std::size_t width_;
    Volume volume_;
    VolumeCuts cuts_;
    std::uint64_t seed_;
    bool writes_rates_ = false;
    cl::Kernel kernel_;
};

}  // namespace pelage
