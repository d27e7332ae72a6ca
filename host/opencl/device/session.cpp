// See session.hpp.
#include "opencl/device/session.hpp"

#include "core/subnormal.hpp"
#include "opencl/device/cl_error.hpp"
#include "opencl/device/context.hpp"
#include "opencl/device/pocl_programs.hpp"
#include "opencl/device/program.hpp"
#include "opencl/device/program_log.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace pelage {

Session::Session(DeviceInfo info, OpenclOptions options) : info_(std::move(info)), options_(std::move(options)) {
    if (options_.units != 0 && options_.units < info_.compute_units)
        info_.compute_units = static_cast<std::uint32_t>(options_.units);
    with_device(info_.name, [&] {
        const SubnormalsAreZero scope(!is_double());  // see list_devices()
        device_ = cl::Device(static_cast<cl_device_id>(info_.id), true);
        context_ = shared_context(device_);
        queue_ = cl::CommandQueue(*context_, device_);
        if (options_.guarded && !info_.watches_memory()) guards_ = std::make_unique<Guards>(*context_, queue_, device_);
    });
}

Session::~Session() {
    // Launches that nobody waited for may still be compiled: a process that ends meanwhile is aborted.
    if (queue_() != nullptr) clFinish(queue_());
    if (options_.use_cache) keep_compiled(*this);
}

std::string Session::build_options() const {
    std::string text = "-cl-std=CL1.2";
    text += is_double() ? " -DPELAGE_DOUBLE" : " -cl-denorms-are-zero";
    if (options_.fast) return text + " -DPELAGE_FAST -cl-fast-relaxed-math";
    if (info_.correctly_rounded_divide_sqrt) text += " -cl-fp32-correctly-rounded-divide-sqrt";
    return text;
}

cl::Program Session::build(const std::string& source, const std::string& more) const {
    const std::string options = more.empty() ? build_options() : build_options() + " " + more;
    const std::string key = options + "\n" + source;
    const std::lock_guard lock(building_);
    const auto known = programs_.find(key);
    if (known != programs_.end()) return known->second;
    const BuiltProgram built = build_program(*this, source, options);
    ++(built.compiled ? counts_.compiled : counts_.cached);
    return programs_.emplace(key, built.program).first->second;
}

ProgramCounts Session::program_counts() const {
    const std::lock_guard lock(building_);
    return counts_;
}

std::size_t Session::programs() const {
    const std::lock_guard lock(building_);
    return programs_.size();
}

cl::Buffer Session::buffer(std::size_t bytes, const std::string& what, cl_mem_flags flags) const {
    const std::size_t size = std::max<std::size_t>(bytes, 1);  // OpenCL has no empty buffers
    if (size > info_.max_allocation) {
        throw Error(fmt::format("the {} needs a buffer of {} bytes; device '{}' allows at most {}", what, size,
                                info_.name, info_.max_allocation));
    }
    try {
        return guards_ ? guards_->allocate(size, what, flags) : cl::Buffer(*context_, flags, size);
    } catch (const cl::Error& error) {
        throw Error(
            fmt::format("no buffer of {} bytes for the {}: {}", size, what, cl_failure(error, info_.name).what()));
    }
}

void Session::launch(const cl::Kernel& kernel, const cl::NDRange& global, const cl::NDRange& local) const {
    try {
        queue_.enqueueNDRangeKernel(kernel, cl::NullRange, global, local);
    } catch (const cl::Error& error) {
        // A kernel may need so much that fewer work-items fit into a group than the device says. How they are grouped
        // changes no result.
        const cl::size_type items = local.get()[0];
        if (error.err() != CL_INVALID_WORK_GROUP_SIZE || items <= 1) throw;
        const cl::size_type fewer = items % 2 == 0 ? items / 2 : 1;
        const std::size_t dimensions = local.dimensions();
        launch(kernel, global,
               dimensions == 1   ? cl::NDRange(fewer)
               : dimensions == 2 ? cl::NDRange(fewer, 1)
                                 : cl::NDRange(fewer, 1, 1));
        return;
    }
    log_launch(kernel);
    if (guards_) guards_->check(kernel.getInfo<CL_KERNEL_FUNCTION_NAME>());
}

void Session::poison_buffer(const cl::Buffer& buffer, std::size_t bytes) const {
    if (guards_ && bytes > 0) queue_.enqueueFillBuffer(buffer, poison, 0, bytes);
}

}  // namespace pelage
