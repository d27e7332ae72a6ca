// Free cells on one OpenCL device.
#pragma once

#include "core/neighbours.hpp"
#include "core/tissue.hpp"
#include "opencl/neighbours_bins.hpp"
#include "opencl/session.hpp"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

namespace pelage {

struct CellsOptions {
    NeighbourSearch search = NeighbourSearch::bins;  // bins and kd_tree both mean the exact sets
    SpatialSorting sorting;                          // for spatial_sorting
    // Of the exact search. None of these changes a result.
    double skin = 0.3;       // how much farther than 3 lists look, so that they last while cells move
    std::size_t batch = 32;  // most iterations that are enqueued before the host looks at them
    int list_capacity = 32;  // entries a list to begin with, at least 16
    std::optional<NeighbourTuning> tuning;
};

// What keeps an experiment with free cells from running on OpenCL; empty: nothing.
std::string why_not_cells(const Experiment&);

// Float results equal those of the float reference bit for bit where the device rounds division and square root
// correctly. Throws Error for a lattice, for a spatial sorting window that is not offered, when
// why_not_cells() has a reason, and, now or while the tissue grows, when its cells do not fit the device's memory.
std::unique_ptr<Tissue> make_opencl_cells(std::shared_ptr<const Session>, std::shared_ptr<const Experiment>,
                                          const Snapshot& initial, const CellsOptions& = {});

}  // namespace pelage
