// What `pelage check` tells of a run that it does not make.
#pragma once

#include "core/experiment.hpp"
#include "language/lint.hpp"

#include <optional>

namespace pelage::app {

// Throws Error where an expression of a start or of a field gives what no cell can have. Of tissues too large to be
// looked at quickly nothing is told.
void check_start(const Experiment&);

// Where the run needs more memory than there is, or than the device has that it would take.
std::optional<Warning> warn_of_size(const Experiment&, const Outline&);

}  // namespace pelage::app
