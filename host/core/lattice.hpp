// What both backends must agree on before they step a lattice: shape, stencil, and which formula a chemical needs.
#pragma once

#include "core/experiment.hpp"
#include "core/snapshot.hpp"
#include "core/space.hpp"

#include <cstddef>
#include <vector>

namespace pelage {

enum class RateKind {
    none,     // 0 everywhere and for good: the chemical does not diffuse
    uniform,  // the same in all cells at any one time
    per_cell  // differs between cells, or a rule may make it differ, or direction matters (anisotropic)
};

struct LatticePlan : Lattice {
    std::vector<RateKind> rates;  // one a chemical
    bool polarity = false;        // any rule or chemical reads or writes polarity
};

// Throws Error when the experiment is not a lattice.
LatticePlan lattice_plan(const Experiment&, const Snapshot& initial);

}  // namespace pelage
