// Which lattices can be members of one batch, and how many there is room for.
#pragma once

#include "core/experiment.hpp"
#include "core/precision.hpp"
#include "core/snapshot.hpp"
#include "opencl/device/device.hpp"

#include <cstddef>
#include <string>

namespace pelage {

// A text that two lattices share where they differ in numbers, seed and state alone: the same programs fit both at the
// same iterations. Empty where a lattice cannot be a member: it grows, or is something else.
std::string structure_of(const Experiment&, const Snapshot& initial, Precision);

// Members of that kind whose states the device can hold at once; 0 where not even one fits.
std::size_t batch_room(const DeviceInfo&, const Experiment&, const Snapshot&, Precision);

}  // namespace pelage
