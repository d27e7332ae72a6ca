// One OpenCL context a device.
#pragma once

#include "opencl/device/cl.hpp"

#include <memory>

namespace pelage {

// The context of all who use a device now; made anew once nobody does. Each context costs time and memory on the
// device, and NVIDIA's driver allows some dozens of them in all processes together.
std::shared_ptr<const cl::Context> shared_context(const cl::Device&);

}  // namespace pelage
