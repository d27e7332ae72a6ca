// The OpenCL devices of this machine and the choice of one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace pelage {

struct DeviceInfo {
    std::size_t index = 0;  // place in list_devices()
    std::string platform;
    std::string platform_version;
    std::string name;
    std::string vendor;
    std::string version;  // "OpenCL 3.0 ..."
    std::string driver;
    std::string type;                  // "gpu", "cpu", "accelerator" or "other"
    std::uint64_t memory = 0;          // bytes
    std::uint64_t max_allocation = 0;  // bytes in one buffer
    std::uint32_t compute_units = 0;
    std::uint64_t local_memory = 0;        // bytes that a work-group has
    bool own_local_memory = false;         // that is memory of its own, not a part of all
    std::size_t max_work_group = 0;        // work-items in a group that has one dimension
    std::uint32_t vector_width_float = 1;  // lanes the hardware has
    std::uint32_t vector_width_double = 0;
    bool fp64 = false;
    bool correctly_rounded_divide_sqrt = false;  // of float; double always is
    std::string unusable;                        // why it cannot be used; empty when it can
    void* id = nullptr;                          // cl_device_id

    // Draws by CPU behind a GPU driver's interface (llvmpipe, Clover): the last resort.
    bool software_rasteriser() const;
    // Turns of all its loops that an item of a launch may take there, with some to spare: llvmpipe ends it silently
    // after 65,535.
    static constexpr std::size_t rasteriser_turns = 50'000;

    // A CPU proper: it runs the work-items of a group one after the other, in vectors.
    bool processor() const { return type == "cpu" && !software_rasteriser(); }

    // Watches every access itself (Oclgrind): guard zones would hide from it what lies outside a buffer, and filling
    // memory what was never written.
    bool watches_memory() const;

    // Work-groups that can run at once, and so may wait for each other: the compute units, but on a CPU not more than
    // this process has processors.
    std::size_t running_units() const;
    std::size_t processors =
        std::numeric_limits<std::size_t>::max();  // those that this process may use; of interest where `type` is "cpu"
};

// All devices of all platforms, in the loader's order. A device that fails while being queried is listed with the
// reason in `unusable`; so is, at the end and by the name "unknown", a platform that fails. Throws Error when the
// loader cannot even list platforms; none at all is no error.
// Drivers that would not fit into this process are not even loaded: none is listed then.
std::vector<DeviceInfo> list_devices();

// Why list_devices() found none, in one sentence.
std::string why_no_devices();

// Whether this process has loaded drivers, by list_devices().
bool drivers_started();

// The place in `devices` of the one that `wanted` names: an index, a type (gpu, cpu, accelerator) or a part of the
// name, or else of its platform's name or version, in any case. Without `wanted`, and among those that a type or name
// fits: the first usable GPU that is not a software rasteriser, else the first such CPU, else accelerator, else
// whatever is usable; so of two platforms with the same device the first one's is taken, and an index says otherwise.
// Throws Error listing what is there.
std::size_t choose_device(const std::vector<DeviceInfo>& devices, const std::optional<std::string>& wanted);

// choose_device among list_devices(); without `wanted` the environment variable PELAGE_DEVICE is obeyed, if set.
DeviceInfo select_device(const std::optional<std::string>& wanted = {});

}  // namespace pelage
