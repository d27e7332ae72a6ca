// From a mesh to what cells at its vertices need.
#pragma once

#include "core/surface.hpp"

#include <memory>
#include <string>
#include <vector>

namespace pelage {

// Throws Error as mesh_adjacency() does.
std::shared_ptr<const MeshSurface> make_surface(Mesh, MeshWeights, std::vector<std::string> notes = {});

}  // namespace pelage
