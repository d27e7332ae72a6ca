// The OpenCL backend: any experiment, compiled for one device.
#pragma once

#include "core/batch.hpp"
#include "core/tissue.hpp"
#include "opencl/device/device.hpp"
#include "opencl/device/options.hpp"

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace pelage {

class OpenclBackend : public Backend {
public:
    virtual const DeviceInfo& device() const = 0;
    virtual std::string build_options() const = 0;  // as handed to the device's compiler

    // Lattices of one structure, which differ in numbers, seed and state alone, can be a batch: launches are of all of
    // them. Equal for such lattices; empty for what cannot be in a batch, as it grows or is no lattice.
    virtual std::string structure(const Experiment&, const Snapshot& initial) const = 0;
    // How many of that kind the device has room for.
    virtual std::size_t batch_room(const Experiment&, const Snapshot& initial) const = 0;
    // Throws Error where they are not of one structure.
    virtual std::unique_ptr<Batch> make_batch(const std::vector<BatchStart>&) = 0;
};

// Throws Error when no such device is there. why_not() of the backend, not this call, says that a device lacks double.
std::unique_ptr<OpenclBackend> opencl_backend(const OpenclOptions& = {});

}  // namespace pelage
