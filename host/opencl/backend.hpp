// The OpenCL backend: any experiment, compiled for one device.
#pragma once

#include "core/neighbours.hpp"
#include "core/tissue.hpp"
#include "opencl/device.hpp"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

namespace pelage {

// Whether a lattice carries out several iterations in one pass over memory, where its rules allow that. The bits are
// the same; the program takes longer to compile, so short runs do without.
enum class Fusion { automatic, always, never };

struct OpenclOptions {
    std::optional<std::string> device;  // index, type or part of the name; see choose_device
    Precision precision = Precision::single_;
    bool use_cache = true;  // compiled programs kept on disk
    // Lets the compiler contract and reorder floating-point arithmetic: faster on some devices, and equality with
    // the reference, even from run to run of another build, is given up.
    bool fast = false;
    std::size_t work_group = 0;  // work-items in a group; 0: ours to choose
    std::size_t variants = 16;   // programs for sets of active rules before one that tests all intervals itself
    std::size_t width = 0;       // cells a work-item handles side by side, 1, 2, 4, 8 or 16; 0: ours to choose
    Fusion fusion = Fusion::automatic;
    NeighbourSearch neighbours = NeighbourSearch::bins;  // of free cells
    SpatialSorting sorting;                              // for spatial_sorting
};

class OpenclBackend : public Backend {
public:
    virtual const DeviceInfo& device() const = 0;
    virtual std::string build_options() const = 0;  // as handed to the device's compiler
};

// Throws Error when no such device is there. why_not() of the backend, not this call, says that a device lacks double.
std::unique_ptr<OpenclBackend> opencl_backend(const OpenclOptions& = {});

}  // namespace pelage
