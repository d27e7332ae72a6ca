// See session.hpp.
#include "opencl/session.hpp"

#include "opencl/cl_error.hpp"
#include "opencl/program.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace pelage {

Session::Session(DeviceInfo info, OpenclOptions options) : info_(std::move(info)), options_(std::move(options)) {
    with_device(info_.name, [&] {
        device_ = cl::Device(static_cast<cl_device_id>(info_.id), true);
        context_ = cl::Context(device_);
        queue_ = cl::CommandQueue(context_, device_);
    });
}

std::string Session::build_options() const {
    std::string text = "-cl-std=CL1.2";
    if (is_double()) text += " -DPELAGE_DOUBLE";
    if (options_.fast) return text + " -DPELAGE_FAST -cl-fast-relaxed-math";
    if (info_.correctly_rounded_divide_sqrt) text += " -cl-fp32-correctly-rounded-divide-sqrt";
    return text;
}

cl::Program Session::build(const std::string& source, const std::string& more) const {
    return build_program(*this, source, more.empty() ? build_options() : build_options() + " " + more);
}

cl::Buffer Session::buffer(std::size_t bytes, const std::string& what, cl_mem_flags flags) const {
    const std::size_t size = std::max<std::size_t>(bytes, 1);  // OpenCL has no empty buffers
    if (size > info_.max_allocation) {
        throw Error(fmt::format("the {} needs a buffer of {} bytes; device '{}' allows at most {}", what, size,
                                info_.name, info_.max_allocation));
    }
    return with_device(info_.name, [&] { return cl::Buffer(context_, flags, size); });
}

}  // namespace pelage
