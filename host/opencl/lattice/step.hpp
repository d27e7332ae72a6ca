// The kernel that carries out iterations of a lattice under one set of active rules.
#pragma once

#include "core/experiment.hpp"
#include "core/lattice.hpp"
#include "opencl/device/pace.hpp"
#include "opencl/device/session.hpp"
#include "opencl/lattice/shared_steps.hpp"
#include "opencl/lattice/state.hpp"

#include <cstdint>
#include <memory>
#include <string>
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

// a / b, rounded up.
inline std::size_t divided(std::size_t a, std::size_t b) { return (a + b - 1) / b; }

bool is_cpu(const DeviceInfo&);  // a processor proper, not a rasteriser that runs on one
bool is_cpu(const Session&);

// Numbers side by side in its vectors: 1, 2, 4, 8 or 16.
std::size_t vector_lanes(const DeviceInfo&, Precision);

// Cells that a work-item handles side by side: the lanes of a CPU, 1 on other devices.
std::size_t lattice_width(const Session&);

// Whether tiles in local memory are faster than a launch an iteration: where local memory is not just memory.
bool tiles_pay(const Session&);

// Whether so many bytes stay in the caches of the threads that work on them.
bool caches_hold(const DeviceInfo&, double bytes);

// Whether so much lies ahead under one set of rules that a streamed program, which takes seconds to compile, pays.
// `cached`: caches hold the lattice, so that less is gained. `done`: cell-updates under these rules so far, which is
// all there is to go by past the experiment's last iteration.
bool streaming_pays(const Experiment&, const std::vector<bool>& active, std::uint64_t iteration, double cells,
                    bool cached, double done);

// Whether the device's work-groups share the steps of small lattices instead of being launched for each.
bool shares_steps(const Session&);

// `together`: the kernel is of that kind; then `bands` is the number of strips. `count`: iterations to come.
LaunchShape launch_shape(const Session&, const Grid&, std::size_t width, bool together, std::uint64_t count);

// Carries out iterations of a lattice under one set of active rules.
class LatticeKernel {
public:
    virtual ~LatticeKernel() = default;
    // Enqueues iterations first .. first + count - 1. `parameters`: see LatticeParameter.
    virtual void enqueue(LatticeState&, const cl::Buffer& parameters, std::uint64_t first, std::uint64_t count,
                         Pace&) = 0;
    virtual std::string describe() const = 0;  // how it carries them out, in a few words
};

// The plain kernel, for any set of rules.
class LatticeStep final : public LatticeKernel {
public:
    // Rules that are not `active` are left out; with `test_intervals` the kernel tests when the others act. `means`: of
    // rates between neighbours, null where they are taken in every iteration.
    LatticeStep(const Session&, const Experiment&, const LatticePlan&, const std::vector<bool>& active,
                bool test_intervals, std::shared_ptr<LatticeMeans> means);

    void enqueue(LatticeState&, const cl::Buffer& parameters, std::uint64_t first, std::uint64_t count, Pace&) override;
    std::string describe() const override;

private:
    void set_arguments(LatticeState&, const cl::Buffer& parameters, const LaunchShape&, std::uint64_t first,
                       std::uint64_t steps);

    const Session& session_;
    std::size_t width_;
    std::uint64_t seed_;
    bool writes_rates_ = false;
    bool writes_polarity_ = false;
    bool together_;
    SharedSteps shared_;
    std::shared_ptr<LatticeMeans> means_;
    cl::Kernel kernel_;
};

}  // namespace pelage
