// The search for concentrations of a lattice that are no longer numbers; see kernels/lattice/non_finite.cl.
#pragma once

#include "core/tissue.hpp"
#include "opencl/device/session.hpp"
#include "opencl/lattice/state.hpp"

#include <optional>

namespace pelage {

class LatticeNonFinite {
public:
    explicit LatticeNonFinite(const Session&);

    std::optional<NonFinite> first_in(const LatticeState&);

private:
    const Session& session_;
    cl::Kernel kernel_;
    cl::Buffer found_;  // of each chemical, the first cell
};

}  // namespace pelage
