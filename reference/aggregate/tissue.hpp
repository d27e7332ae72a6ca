// Aggregates on the reference.
#pragma once

#include "core/tissue.hpp"

#include <memory>

namespace pelage {

// Sums are whole numbers and weights float, whatever the precision of the run: both precisions take the same sites.
std::unique_ptr<Tissue> make_reference_aggregate(std::shared_ptr<const Experiment>, const Snapshot& initial);

}  // namespace pelage
