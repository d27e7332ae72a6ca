// Free cells on one OpenCL device.
#pragma once

#include "core/tissue.hpp"
#include "opencl/cells/options.hpp"
#include "opencl/device/session.hpp"

#include <memory>
#include <string>

namespace pelage {

// What keeps an experiment with free cells from running on OpenCL; empty: nothing.
std::string why_not_cells(const Experiment&);

// Float results equal those of the float reference bit for bit where the device rounds division and square root
// correctly. Throws Error for a lattice, for a spatial sorting window that is not offered, when
// why_not_cells() has a reason, and, now or while the tissue grows, when its cells do not fit the device's memory.
std::unique_ptr<Tissue> make_opencl_cells(std::shared_ptr<const Session>, std::shared_ptr<const Experiment>,
                                          const Snapshot& initial, const CellsOptions& = {});

}  // namespace pelage
