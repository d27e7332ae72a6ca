// Cells as a table.
#pragma once

#include "core/experiment.hpp"
#include "core/snapshot.hpp"

#include <filesystem>

namespace pelage {

// A line a cell, in order of id: id,x,y,birth,neighbours,polarity_x,polarity_y,conc NAME...,diff NAME...
// Numbers as %.9g: enough for every float. Throws Error when the file cannot be written or the arrays do not fit.
void write_csv(const std::filesystem::path&, const Snapshot&, const Experiment&);

}  // namespace pelage
