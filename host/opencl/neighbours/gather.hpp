// What cells exchange with their neighbours in any space, on a device; see kernels/neighbours/gather.cl.
#pragma once

#include "core/adjacency.hpp"
#include "opencl/device/session.hpp"

#include <cstddef>

namespace pelage {

class Gather {
public:
    // Throws Error where a device cannot count so many entries.
    Gather(const Session&, const Adjacency&, Arithmetic);

    // next += what each cell takes from its neighbours in a time step `dt`. Each buffer holds one number a cell, in the
    // session's precision.
    void run(const cl::Buffer& rates, const cl::Buffer& old, const cl::Buffer& next, double dt);

private:
    const Session& session_;
    std::size_t cells_;
    cl::Kernel kernel_;
    cl::Buffer offsets_, indices_, weights_;
};

}  // namespace pelage
