// `--random N`: parameters drawn within the ranges that an experiment declares.
#pragma once

#include "core/experiment.hpp"

#include <cstdint>
#include <vector>

namespace pelage::app {

// A value for each parameter that has a lowest and a highest one, uniform between them, whole where a statement needs a
// whole number; rounded to six digits. The same `draw` gives the same values everywhere. Throws Error where no
// parameter has a range.
std::vector<Setting> random_settings(const Experiment&, std::uint64_t draw);

}  // namespace pelage::app
