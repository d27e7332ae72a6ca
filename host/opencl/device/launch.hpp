// Kernel arguments and launches in one line each.
#pragma once

#include "core/subnormal.hpp"
#include "opencl/device/cl.hpp"
#include "opencl/device/session.hpp"

#include <algorithm>
#include <cstddef>

namespace pelage {

struct Scalar {  // a number that kernels take as `scalar`: float or double after the session's precision
    double value = 0.0;
};

class Arguments {
public:
    Arguments(const Session& session, cl::Kernel& kernel, cl_uint next = 0)
        : session_(session), kernel_(kernel), next_(next) {}

    template <class... Values>
    Arguments& add(const Values&... values) {
        (set(values), ...);
        return *this;
    }

    cl_uint next() const { return next_; }

private:
    void set(const Scalar& scalar) {
        if (session_.is_double()) {
            kernel_.setArg(next_++, static_cast<cl_double>(scalar.value));
        } else {
            kernel_.setArg(next_++, in_precision<cl_float>(scalar.value));
        }
    }
    void set(const cl::Buffer& buffer) { kernel_.setArg(next_++, buffer); }
    void set(cl_int value) { kernel_.setArg(next_++, value); }
    void set(std::size_t count) { set(static_cast<cl_int>(count)); }
    void set(cl_uint value) { kernel_.setArg(next_++, value); }

    const Session& session_;
    cl::Kernel& kernel_;
    cl_uint next_;
};

// At least `items` work-items in groups of `wanted`, or fewer where the device has a limit.
inline void launch(const Session& session, const cl::Kernel& kernel, std::size_t items, std::size_t wanted = 1) {
    const std::size_t group = std::min(wanted, std::max<std::size_t>(1, session.info().max_work_group));
    const std::size_t groups = std::max<std::size_t>(1, (items + group - 1) / group);
    session.launch(kernel, cl::NDRange(groups * group), cl::NDRange(group));
}

}  // namespace pelage
