// Why a lattice is carried out as it is, in words.
#pragma once

#include "core/experiment.hpp"
#include "core/precision.hpp"
#include "core/snapshot.hpp"
#include "opencl/device/device.hpp"

#include <string>
#include <vector>

namespace pelage {

// A processor with the threads that this process may use.
DeviceInfo usual_processor();

// One sentence for each set of rules that act at the same time: from which iteration on, which rules, and how a whole
// run's iterations are carried out on that device and why. Empty for free cells.
std::vector<std::string> explain_lattice(const Experiment&, const Snapshot& initial, Precision, const DeviceInfo&);

}  // namespace pelage
