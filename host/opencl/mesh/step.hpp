// The step of a mesh's cells for one set of rules, put together and compiled; see kernels/mesh/step.cl.
#pragma once

#include "core/rates.hpp"
#include "opencl/device/pace.hpp"
#include "opencl/device/session.hpp"
#include "opencl/mesh/state.hpp"
#include "opencl/rules/numbers.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pelage {

// In the order of the kernel's places: time step, when the phase began, bounds, the numbers of rules.
std::vector<KernelNumber> mesh_parameters(const Experiment&, const Phase&, Precision);

class MeshStep {
public:
    // `test_intervals`: the kernel itself tests which of the rules act.
    MeshStep(const Session&, const Experiment&, const std::vector<RateKind>& rates, const std::vector<bool>& active,
             bool test_intervals);

    // Iterations first .. first + count - 1, a launch each.
    void enqueue(MeshState&, const cl::Buffer& parameters, std::uint64_t first, std::uint64_t count, Pace&);

private:
    std::size_t group_for(std::size_t items) const;

    const Session& session_;
    std::uint64_t seed_;
    std::size_t lanes_;  // cells that a work-item takes
    bool writes_rates_ = false;
    cl::Kernel kernel_;
};

}  // namespace pelage
