// A tissue of whatever kind on one OpenCL device.
#pragma once

#include "core/tissue.hpp"
#include "opencl/device/session.hpp"

#include <memory>

namespace pelage {

// Free cells are searched as the session's options say. Throws Error as make_opencl_lattice() and make_opencl_cells()
// do.
std::unique_ptr<Tissue> make_opencl_tissue(std::shared_ptr<const Session>, std::shared_ptr<const Experiment>,
                                           const Snapshot& initial);

}  // namespace pelage
