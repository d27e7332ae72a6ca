// Where an experiment will run: the reference or an OpenCL device, and why that one.
#pragma once

#include "app/memory.hpp"
#include "app/run_options.hpp"
#include "core/experiment.hpp"
#include "core/tissue.hpp"
#include "opencl/backend.hpp"

#include <memory>
#include <optional>
#include <string>

namespace pelage::app {

struct Machine {
    std::unique_ptr<Backend> backend;
    std::string kind;    // "reference" or "opencl"
    std::string why;     // why not opencl, when nobody asked for the reference; else empty
    std::string device;  // its name
    std::string driver;  // its version; the compiler's for the reference
    std::string platform;
    std::string build_options;
    std::optional<OpenclOptions> opencl;  // what the backend was made with, its device named by index
    DeviceInfo info;                      // of an OpenCL device
    std::string tuning;                   // what was chosen for a lattice on OpenCL; see tuning.hpp
};

Worked worked(const Machine&);

// Throws Error where a device is named for the reference, which has none.
void check_device(const std::string& backend, const std::string& device);

// Whether PELAGE_DEVICE asks for a device.
bool variable_chooses_device();

// Without options.backend: OpenCL where a device is usable for this experiment, else the reference. A backend or device
// that was asked for and cannot be had is an Error, never replaced by another one.
Machine choose_machine(const RunOptions&, const Experiment&, const Footprint&);

}  // namespace pelage::app
