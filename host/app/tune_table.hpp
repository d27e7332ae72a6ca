// What the tuner found, as a table to read.
#pragma once

#include "app/tuning.hpp"

#include <string>

namespace pelage::app {

// The fastest first; then what was struck out, with why; then what later runs will take.
std::string tuning_table(const Tuning&, const DeviceInfo&);

}  // namespace pelage::app
