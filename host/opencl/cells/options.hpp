// How free cells are stepped on a device.
#pragma once

#include "core/neighbours.hpp"
#include "opencl/neighbours/bins.hpp"

#include <cstddef>
#include <optional>

namespace pelage {

struct CellsOptions {
    NeighbourSearch search = NeighbourSearch::bins;  // bins and kd_tree both mean the exact sets
    SpatialSorting sorting;                          // for spatial_sorting
    // Of the exact search. None of these changes a result.
    double skin = 0.3;       // how much farther than 3 lists look, so that they last while cells move
    std::size_t batch = 32;  // most iterations that are enqueued before the host looks at them
    int list_capacity = 12;  // entries a list to begin with, at least 8: lists that are read whole keep the memory busy
    std::optional<NeighbourTuning> tuning;
    std::optional<bool> together;  // many iterations a launch by one work-group; none: where that is faster

    bool approximate() const { return search == NeighbourSearch::spatial_sorting; }
};

}  // namespace pelage
