// Cells as a table.
#pragma once

#include "core/experiment.hpp"
#include "core/precision.hpp"
#include "core/snapshot.hpp"

#include <filesystem>

namespace pelage {

// A line a cell, in order of id: id,x,y,birth,neighbours,polarity_x,polarity_y,conc NAME...,diff NAME...
// Numbers of a run in float as %.9g, which tells every float from the others; of a run in double with as few digits as
// tell every double from the others, at most 17. Throws Error when the file cannot be written or the arrays do not fit.
void write_csv(const std::filesystem::path&, const Snapshot&, const Experiment&, Precision);

}  // namespace pelage
