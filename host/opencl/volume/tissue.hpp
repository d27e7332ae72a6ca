// A volume on one OpenCL device: all of a lattice's tissue but its steps.
#pragma once

#include "core/tissue.hpp"
#include "opencl/device/session.hpp"

#include <memory>

namespace pelage {

std::unique_ptr<Tissue> make_opencl_volume(std::shared_ptr<const Session>, std::shared_ptr<const Experiment>,
                                           const Snapshot& initial);

}  // namespace pelage
