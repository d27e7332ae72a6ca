// See surface.hpp.
#include "mesh/surface.hpp"

#include "mesh/adjacency.hpp"
#include "mesh/locality.hpp"

#include <utility>

namespace pelage {

std::shared_ptr<const MeshSurface> make_surface(Mesh mesh, MeshWeights weights, std::vector<std::string> notes) {
    MeshSurface surface;
    surface.weights = weights;
    surface.notes = std::move(notes);
    surface.adjacency = mesh_adjacency(mesh, weights);
    surface.order = locality_order(surface.adjacency);
    surface.mesh = std::move(mesh);
    return std::make_shared<const MeshSurface>(std::move(surface));
}

}  // namespace pelage
