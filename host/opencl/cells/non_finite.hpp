// The search for concentrations of free cells that are no longer numbers; see kernels/cells/non_finite.cl.
#pragma once

#include "core/tissue.hpp"
#include "opencl/cells/state.hpp"
#include "opencl/device/session.hpp"

#include <cstddef>
#include <optional>

namespace pelage {

class CellsNonFinite {
public:
    // `service`: a program with cells/non_finite.cl. `group`: work-items that a group should have.
    CellsNonFinite(const Session&, const cl::Program& service, std::size_t group);

    std::optional<NonFinite> first_in(const CellsState&);

private:
    const Session& session_;
    std::size_t group_;
    cl::Kernel kernel_;
    cl::Buffer found_;
};

}  // namespace pelage
