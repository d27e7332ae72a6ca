// The flags by which work-groups share the steps of a small lattice; see kernels/lattice/together.cl.
#pragma once

#include "opencl/device/launch.hpp"
#include "opencl/device/session.hpp"

#include <cstddef>

namespace pelage {

class SharedSteps {
public:
    explicit SharedSteps(const Session& session) : session_(session) {}

    // Adds what the kernel's next launch takes, by `strips` work-groups and with `steps` levels.
    void prepare(Arguments&, std::size_t strips, std::size_t steps);

private:
    const Session& session_;
    cl::Buffer flags_;
    std::size_t strips_ = 0;
    cl_int levels_ = 0;    // done by the launches so far
    cl_int arrivals_ = 0;  // of work-groups
};

}  // namespace pelage
