// See device.hpp.
#include "opencl/device/device.hpp"

#include "core/allowance.hpp"
#include "core/subnormal.hpp"
#include "opencl/device/cl_error.hpp"
#include "opencl/device/kept_handlers.hpp"
#include "opencl/device/pocl.hpp"
#include "opencl/device/room.hpp"
#include "opencl/device/schedule.hpp"
#include "opencl/device/spelling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cstdio>

namespace pelage {

namespace {

std::atomic<bool> started{false};

std::string type_name(cl_device_type type) {
    if ((type & CL_DEVICE_TYPE_GPU) != 0) return "gpu";
    if ((type & CL_DEVICE_TYPE_CPU) != 0) return "cpu";
    if ((type & CL_DEVICE_TYPE_ACCELERATOR) != 0) return "accelerator";
    return "other";
}

std::string why_unusable(const cl::Device& device) {
    if (device.getInfo<CL_DEVICE_AVAILABLE>() == CL_FALSE) return "the device is not available";
    if (device.getInfo<CL_DEVICE_COMPILER_AVAILABLE>() == CL_FALSE) return "the device has no compiler";
    if (device.getInfo<CL_DEVICE_ENDIAN_LITTLE>() == CL_FALSE) return "the device is big-endian";
    unsigned major = 0;
    unsigned minor = 0;
    const std::string version = device.getInfo<CL_DEVICE_VERSION>();
    if (std::sscanf(version.c_str(), "OpenCL %u.%u", &major, &minor) != 2 || major * 10 + minor < 12) {
        return fmt::format("OpenCL 1.2 is needed, the device has '{}'", trimmed(version));
    }
    return "";
}

// The answer, or `fallback` from a driver that does not know the question.
template <cl_device_info question, class Answer>
Answer answer_or(const cl::Device& device, Answer fallback) {
    try {
        return device.getInfo<question>();
    } catch (const cl::Error& error) {
        if (error.err() != CL_INVALID_VALUE) throw;
        return fallback;
    }
}

// Work-items in a group along the first dimension.
std::size_t largest_group(const cl::Device& device) {
    const std::size_t items = device.getInfo<CL_DEVICE_MAX_WORK_GROUP_SIZE>();
    const std::vector<std::size_t> sides = device.getInfo<CL_DEVICE_MAX_WORK_ITEM_SIZES>();
    return sides.empty() ? items : std::min(items, sides.front());
}

void query(const cl::Device& device, DeviceInfo& info) {
    info.name = trimmed(device.getInfo<CL_DEVICE_NAME>());
    info.vendor = trimmed(device.getInfo<CL_DEVICE_VENDOR>());
    info.version = trimmed(device.getInfo<CL_DEVICE_VERSION>());
    info.driver = trimmed(device.getInfo<CL_DRIVER_VERSION>());
    info.type = type_name(device.getInfo<CL_DEVICE_TYPE>());
    info.memory = device.getInfo<CL_DEVICE_GLOBAL_MEM_SIZE>();
    info.max_allocation = device.getInfo<CL_DEVICE_MAX_MEM_ALLOC_SIZE>();
    info.compute_units = device.getInfo<CL_DEVICE_MAX_COMPUTE_UNITS>();
    info.processors = schedule().empty() ? usable_processors() : info.compute_units;
    info.local_memory = device.getInfo<CL_DEVICE_LOCAL_MEM_SIZE>();
    info.own_local_memory = device.getInfo<CL_DEVICE_LOCAL_MEM_TYPE>() == CL_LOCAL;
    info.max_work_group = largest_group(device);
    info.vector_width_float = std::max(1u, device.getInfo<CL_DEVICE_NATIVE_VECTOR_WIDTH_FLOAT>());
    info.vector_width_double = answer_or<CL_DEVICE_NATIVE_VECTOR_WIDTH_DOUBLE>(device, cl_uint{0});
    info.fp64 = answer_or<CL_DEVICE_DOUBLE_FP_CONFIG>(device, cl_device_fp_config{0}) != 0;
    info.correctly_rounded_divide_sqrt =
        (device.getInfo<CL_DEVICE_SINGLE_FP_CONFIG>() & CL_FP_CORRECTLY_ROUNDED_DIVIDE_SQRT) != 0;
    info.unusable = why_unusable(device);
}

std::string failure_of(const cl::Error& error) {
    return fmt::format("{} failed with {}", error.what(), cl_error_name(error.err()));
}

DeviceInfo describe(const cl::Device& device, const std::string& platform, const std::string& platform_version) {
    DeviceInfo info;
    info.platform = platform;
    info.platform_version = platform_version;
    info.id = device();
    try {
        query(device, info);
    } catch (const cl::Error& error) {
        if (info.name.empty()) info.name = "unknown";
        if (info.type.empty()) info.type = "other";
        info.unusable = failure_of(error);
    }
    if (info.unusable.empty() && platform == pocl_platform) info.unusable = pocl_trouble();
    return info;
}

// For the devices of a platform that cannot be asked for them.
DeviceInfo stand_in(const std::string& platform, const cl::Error& error) {
    DeviceInfo info;
    info.platform = platform;
    info.name = "unknown";
    info.type = "other";
    info.unusable = failure_of(error);
    return info;
}

std::vector<cl::Platform> list_platforms() {
    constexpr cl_int none_there = -1001;  // CL_PLATFORM_NOT_FOUND_KHR: the loader's word for an empty list
    std::vector<cl::Platform> platforms;
    try {
        cl::Platform::get(&platforms);
    } catch (const cl::Error& error) {
        if (error.err() != none_there) throw Error("OpenCL devices cannot be listed: " + failure_of(error));
    }
    return platforms;
}

std::vector<cl::Device> devices_of(const cl::Platform& platform) {
    std::vector<cl::Device> devices;
    try {
        platform.getDevices(CL_DEVICE_TYPE_ALL, &devices);
    } catch (const cl::Error& error) {
        if (error.err() != CL_DEVICE_NOT_FOUND) throw;  // that says: none
    }
    return devices;
}

}  // namespace

std::string why_no_devices() {
    if (const std::string reason = drivers_started() ? "" : why_no_room(); !reason.empty()) {
        return "no OpenCL device can be used: " + reason;
    }
    if (!pocl_trouble().empty()) return "no OpenCL device is there: " + pocl_trouble();
    return "no OpenCL device is there; install a driver, such as pocl-opencl-icd";
}

bool drivers_started() { return started; }

bool DeviceInfo::software_rasteriser() const {
    const std::string text = lower(name + " " + platform);
    return text.find("llvmpipe") != std::string::npos || text.find("softpipe") != std::string::npos ||
           text.find("swrast") != std::string::npos || text.find("clover") != std::string::npos;
}

bool DeviceInfo::watches_memory() const { return platform == "Oclgrind"; }

std::size_t DeviceInfo::running_units() const {
    const std::size_t units = std::max<std::size_t>(1, compute_units);
    return type == "cpu" ? std::min(units, processors) : units;
}

// Threads inherit the mode of the one that starts them, and some drivers start theirs here (rusticl): those flush then
// though they do not heed -cl-denorms-are-zero.
std::vector<DeviceInfo> list_devices() {
    const SubnormalsAreZero scope;
    prepare_pocl();
    if (!drivers_started() && !why_no_room().empty()) return {};
    if (process_limit()) be_sparing();
    const KeptHandlers handlers;
    started = true;
    std::vector<DeviceInfo> devices;
    std::vector<DeviceInfo> broken;  // last, so that they move nobody else's index
    for (const cl::Platform& platform : list_platforms()) {
        std::string name = "unknown";
        try {
            name = trimmed(platform.getInfo<CL_PLATFORM_NAME>());
            const std::string version = trimmed(platform.getInfo<CL_PLATFORM_VERSION>());
            for (const cl::Device& device : devices_of(platform)) devices.push_back(describe(device, name, version));
        } catch (const cl::Error& error) {
            broken.push_back(stand_in(name, error));
        }
    }
    devices.insert(devices.end(), broken.begin(), broken.end());
    for (std::size_t i = 0; i < devices.size(); ++i) devices[i].index = i;
    return devices;
}

}  // namespace pelage
