// Aggregates on an OpenCL device.
#pragma once

#include "core/tissue.hpp"
#include "opencl/device/session.hpp"

#include <memory>

namespace pelage {

std::unique_ptr<Tissue> make_opencl_aggregate(std::shared_ptr<const Session>, std::shared_ptr<const Experiment>,
                                              const Snapshot& initial);

}  // namespace pelage
