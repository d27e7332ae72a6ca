// The means of neighbours' diffusion rates, where nothing changes the rates (kernels/lattice/means.cl).
#pragma once

#include "opencl/device/session.hpp"
#include "opencl/lattice/state.hpp"

namespace pelage {

// Whether a lattice gains by them: rates differ between cells, and no rule, at any time, changes those or the polarity.
// `every`: what all rules use. GPUs divide faster than they read planes.
bool means_pay(const Session&, const LatticePlan&, const RuleUse& every);

class LatticeMeans {
public:
    LatticeMeans(const Session&, const Experiment&, const LatticePlan&);

    // Four planes for each chemical with rates of its own, in the order of rate_planes(); computed anew when the
    // state's rates have changed since.
    const cl::Buffer& of(LatticeState&);
    void forget() { version_ = 0; }  // to be called when the state is another one

private:
    const Session& session_;
    cl::Kernel kernel_;
    std::size_t width_;
    Planes planes_;
    std::uint64_t version_ = 0;  // of the state's rates, 0: none yet
};

}  // namespace pelage
