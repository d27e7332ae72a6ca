// The driver of `pelage run`: advances a tissue in batches, shows progress, writes snapshots, checkpoints and results.
#pragma once

#include "app/run_options.hpp"

namespace pelage::app {

// Returns the exit code. Throws Error when the run cannot begin or its results cannot be written.
int run_experiment(const RunOptions&);

}  // namespace pelage::app
