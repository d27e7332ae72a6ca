// Lattices of one structure on one OpenCL device: each launch is of all of them.
#pragma once

#include "core/batch.hpp"
#include "opencl/device/session.hpp"

#include <memory>
#include <vector>

namespace pelage {

// Throws Error where they are of more than one structure, or none (structure.hpp), and where the device has no room.
std::unique_ptr<Batch> make_opencl_batch(std::shared_ptr<const Session>, const std::vector<BatchStart>&);

}  // namespace pelage
