// A lattice or a volume on one OpenCL device.
#pragma once

#include "core/tissue.hpp"
#include "opencl/device/session.hpp"
#include "opencl/lattice/step.hpp"

#include <functional>
#include <memory>
#include <vector>

namespace pelage {

// Makes the kernel for the rules that are active, as LatticeStep's constructor does.
using MakeStep =
    std::function<std::unique_ptr<LatticeKernel>(const Session&, const Experiment&, const LatticePlan&,
                                                 const std::vector<bool>& active, bool test_intervals, const Choice&)>;

// `make_step`: for spaces that have steps of their own (volume/tissue.hpp); empty for a lattice.
std::unique_ptr<Tissue> make_opencl_lattice(std::shared_ptr<const Session>, std::shared_ptr<const Experiment>,
                                            const Snapshot& initial, MakeStep make_step = {});

}  // namespace pelage
