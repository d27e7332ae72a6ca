// Tissues at the vertices of a mesh, on the reference.
#pragma once

#include "core/tissue.hpp"

#include <memory>

namespace pelage {

// Throws Error when the experiment has no mesh, or the state is not one of its vertices.
std::unique_ptr<Tissue> make_reference_mesh(std::shared_ptr<const Experiment>, const Snapshot& initial, Precision);

}  // namespace pelage
