// What both backends must agree on before they step a lattice or a volume: shape, stencil, and which formula a chemical
// needs.
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
    std::size_t layers = 0;       // of a volume; 0: a plane

    bool volume() const { return layers != 0; }
    Volume as_volume() const { return {columns, rows, layers, boundary, stencil}; }
};

// Throws Error for free cells.
LatticePlan lattice_plan(const Experiment&, const Snapshot& initial);

}  // namespace pelage
