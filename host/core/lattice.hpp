// What both backends must agree on before they step a lattice: shape, stencil, and which formula a chemical needs.
#pragma once

#include "core/experiment.hpp"
#include "core/rates.hpp"
#include "core/snapshot.hpp"
#include "core/space.hpp"

#include <cstddef>
#include <vector>

namespace pelage {

struct LatticePlan : Lattice {
    std::vector<RateKind> rates;  // one a chemical
    bool polarity = false;        // any rule or chemical reads or writes polarity
};

// Throws Error when the experiment is not a lattice.
LatticePlan lattice_plan(const Experiment&, const Snapshot& initial);

}  // namespace pelage
