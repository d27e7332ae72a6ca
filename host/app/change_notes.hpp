// What `change` rules add in a unit of time, which no rule says: `change` has no time step in it.
#pragma once

#include "core/experiment.hpp"

#include <string>
#include <vector>

namespace pelage::app {

// A sentence for each rule that changes an amount where an iteration is not one unit of time.
std::vector<std::string> change_notes(const Experiment&);

}  // namespace pelage::app
