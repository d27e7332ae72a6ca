// Equality of states bit for bit, and mistrust of results that prove nothing.
#pragma once

#include "core/snapshot.hpp"

#include <string>
#include <vector>

namespace pelage::verify {

// One line for each array that differs in any bit: its name, how many elements, the first of them with both values.
// +0 and -0 differ; a NaN differs from everything, itself included. Empty: equal.
std::vector<std::string> differences(const Snapshot& expected, const Snapshot& found);

// One line for each chemical that is flat or as it was before.
std::vector<std::string> mistrusted(const Snapshot& before, const Snapshot& after);

}  // namespace pelage::verify
