// Children of free cells, appended on the device.
#pragma once

#include "opencl/cells/source.hpp"
#include "opencl/cells/state.hpp"
#include "opencl/neighbours/bins.hpp"

#include <cstddef>
#include <cstdint>

namespace pelage {

class CellsDivision {
public:
    // `service`: the program of cells/divide.cl.
    CellsDivision(const Session&, NeighbourTuning, const cl::Program& service);

    // Appends the children that the step of `iteration` has asked for; the state before that step is still in the
    // spare arrays of those that it wrote. Throws Error when they do not fit the device's memory.
    void append(CellsState&, const CellsWritten&, std::uint64_t iteration, std::size_t children);

private:
    const Session& session_;
    NeighbourTuning tuning_;
    cl::Kernel count_, append_;
    cl::Buffer sums_;
};

}  // namespace pelage
