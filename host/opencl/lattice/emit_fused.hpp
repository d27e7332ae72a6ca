// The sources of several fused iterations of a lattice (kernels/lattice/stream.cl, kernels/lattice/tile.cl) for one set
// of active rules.
#pragma once

#include "core/experiment.hpp"
#include "core/lattice.hpp"
#include "core/tissue.hpp"
#include "opencl/rules/emit_rules.hpp"

#include <compare>
#include <cstddef>
#include <string>
#include <vector>

namespace pelage {

// How a program of fused iterations is cut to a device.
struct FusedShape {
    std::size_t depth = 1;    // most iterations a launch
    std::size_t rows = 1;     // taken at a time: of a block of a band; or of a tile, without margins
    std::size_t vectors = 1;  // most vectors across a band or a tile, margins included
    std::size_t group = 1;    // work-items
    bool prefetch = false;    // ask for memory before it is needed
    bool together = false;    // strips' work-groups may share the passes of a launch, see lattice/together.cl
    bool batch = false;       // a launch is of several lattices, see emit_batch.hpp

    auto operator<=>(const FusedShape&) const = default;
};

std::string stream_source(const Experiment&, const LatticePlan&, const RuleText&, const std::vector<bool>& bounded,
                          Precision, std::size_t width, const FusedShape&);
std::string tile_source(const Experiment&, const LatticePlan&, const RuleText&, const std::vector<bool>& bounded,
                        Precision, std::size_t width, const FusedShape&);

}  // namespace pelage
