// Tissues of lattices and volumes on the reference.
#pragma once

#include "core/tissue.hpp"

#include <memory>

namespace pelage {

// Throws Error for free cells.
std::unique_ptr<Tissue> make_reference_lattice(std::shared_ptr<const Experiment>, const Snapshot& initial, Precision);

}  // namespace pelage
