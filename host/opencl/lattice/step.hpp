// The kernel that carries out iterations of a lattice under one set of active rules.
#pragma once

#include "core/experiment.hpp"
#include "core/lattice.hpp"
#include "opencl/device/pace.hpp"
#include "opencl/device/session.hpp"
#include "opencl/lattice/choice.hpp"
#include "opencl/lattice/shared_steps.hpp"
#include "opencl/lattice/state.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace pelage {

class LatticeMeans;

// How the work of one launch is dealt out.
struct LaunchShape {
    std::size_t across = 1;      // work-items along a row
    std::size_t bands = 1;       // work-items up the columns
    std::size_t work_group = 1;  // along a row
    std::size_t band = 1;        // rows of a work-item
    std::size_t steps = 1;       // iterations a launch
};

// Of a kernel that is chosen to step or to share steps; then `bands` is the number of strips. `count`: iterations to
// come. `reach`: rows up or down that a cell is looked at from.
LaunchShape launch_shape(const DeviceInfo&, const Choice&, const Grid&, std::uint64_t count, std::size_t reach);

// Of a batch on a processor: a work-item has a lattice to itself, so that none waits for another.
LaunchShape batch_shape(const Grid&, std::uint64_t count, std::size_t lattices_a_thread);

// Carries out iterations of a lattice, or of a batch, under one set of active rules.
class LatticeKernel {
public:
    virtual ~LatticeKernel() = default;
    // Enqueues iterations first .. first + count - 1. `parameters`: see LatticeParameter.
    virtual void enqueue(LatticeState&, const cl::Buffer& parameters, std::uint64_t first, std::uint64_t count,
                         Pace&) = 0;
};

// One iteration after the other: a launch each, or shared.
class LatticeStep final : public LatticeKernel {
public:
    // Rules that are not `active` are left out; with `test_intervals` the kernel tests when the others act. `means`: of
    // rates between neighbours, null where they are taken in every iteration.
    LatticeStep(const Session&, const Experiment&, const LatticePlan&, const std::vector<bool>& active,
                bool test_intervals, Choice, std::shared_ptr<LatticeMeans> means);

    void enqueue(LatticeState&, const cl::Buffer& parameters, std::uint64_t first, std::uint64_t count, Pace&) override;

private:
    void set_arguments(LatticeState&, const cl::Buffer& parameters, const LaunchShape&, std::uint64_t first,
                       std::uint64_t steps);
    LaunchShape next_shape(const LatticeState&, std::uint64_t count) const;

    const Session& session_;
    Choice choice_;
    std::uint64_t seed_;
    std::size_t reach_ = 1;
    bool writes_rates_ = false;
    bool writes_polarity_ = false;
    SharedSteps shared_;
    std::shared_ptr<LatticeMeans> means_;
    cl::Kernel kernel_;
};

}  // namespace pelage
