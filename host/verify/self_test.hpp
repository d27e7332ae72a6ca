// A run in small, before the run: does this device give the reference's answers with the kernels that will be used?
#pragma once

#include "core/experiment.hpp"
#include "core/snapshot.hpp"
#include "opencl/device/options.hpp"

#include <cstdint>
#include <string>

namespace pelage::verify {

// A small piece of a state: cells from the middle of a lattice, the first of free cells.
Snapshot small_piece(const Snapshot&);

// Steps a small piece of `initial` a few iterations with every set of rules that acts until iteration `last`, on the
// device and on the reference, and compares bit for bit; where bits may differ (options.fast, a device that does not
// round division and square roots correctly) within 1e-3 of each value. Empty: equal. Otherwise what differs.
// Throws Error when the device fails.
std::string self_test(const OpenclOptions&, const Experiment&, const Snapshot& initial, std::uint64_t last);

}  // namespace pelage::verify
