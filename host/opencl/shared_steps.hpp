// The flags by which work-groups share the steps of a small lattice; see kernels/lattice_together.cl.
#pragma once

#include "opencl/session.hpp"

#include <cstddef>

namespace pelage {

class SharedSteps {
public:
    explicit SharedSteps(const Session& session) : session_(session) {}

    // Sets the kernel's arguments `place` .. `place` + 3 for its next launch: `strips` work-groups and `steps` levels.
    void prepare(cl::Kernel&, cl_uint place, std::size_t strips, std::size_t steps);

private:
    const Session& session_;
    cl::Buffer flags_;
    std::size_t strips_ = 0;
    cl_int levels_ = 0;    // done by the launches so far
    cl_int arrivals_ = 0;  // of work-groups
};

}  // namespace pelage
