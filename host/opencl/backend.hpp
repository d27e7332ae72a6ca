// The OpenCL backend: any experiment, compiled for one device.
#pragma once

#include "core/tissue.hpp"
#include "opencl/device/device.hpp"
#include "opencl/device/options.hpp"

#include <memory>
#include <string>

namespace pelage {

class OpenclBackend : public Backend {
public:
    virtual const DeviceInfo& device() const = 0;
    virtual std::string build_options() const = 0;  // as handed to the device's compiler
};

// Throws Error when no such device is there. why_not() of the backend, not this call, says that a device lacks double.
std::unique_ptr<OpenclBackend> opencl_backend(const OpenclOptions& = {});

}  // namespace pelage
