// Tissues at the vertices of a mesh, on one OpenCL device.
#pragma once

#include "core/tissue.hpp"
#include "opencl/device/session.hpp"

#include <memory>

namespace pelage {

// Throws Error when the experiment has no mesh, or the state is not one of its vertices.
std::unique_ptr<Tissue> make_opencl_mesh(std::shared_ptr<const Session>, std::shared_ptr<const Experiment>,
                                         const Snapshot& initial);

}  // namespace pelage
