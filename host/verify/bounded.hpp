// Devices that need not round a quotient or a square root of floats correctly: how far off their results may be.
#pragma once

#include "verify/check.hpp"

#include <string>
#include <vector>

namespace pelage::verify {

// Of one iteration, as |difference| / max(1, |expected|). OpenCL allows such a device 2.5 ulp (3 for roots), 4e-7, in
// each of the few divisions of an iteration; the rest is for what sums and differences make of that.
inline constexpr double division_bound = 2e-5;

bool rounds_exactly(const Place&, const Setting&);  // double always is

// All that differs are values within the bound; numbers of cells, ages and neighbours are the same.
bool within_bound(const Tally&);

std::string bound_message();

// One iteration from each of the reference's states, on both sides.
Tally single_iterations(const Experiment&, const std::vector<Snapshot>& states, Place&, const Setting&);

// Of a run that differs somewhere: failed, unless the device need not divide exactly and single iterations from the
// reference's states stay within the bound; the tally is theirs then.
void conclude_bounded(Outcome&, const Experiment&, const std::vector<Snapshot>& states, Place&, const Setting&);

}  // namespace pelage::verify
