// A mesh made ready for cells at its vertices.
#pragma once

#include "core/adjacency.hpp"
#include "core/mesh.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pelage {

// Made by make_surface() of mesh/surface.hpp. Cell i is vertex i.
struct MeshSurface {
    Mesh mesh;
    MeshWeights weights = MeshWeights::uniform;
    Adjacency adjacency;
    std::vector<std::uint32_t> order;  // the vertices in an order in which neighbours are near each other
    std::vector<std::string> notes;    // what of a file was put right, a sentence each

    std::size_t cells() const { return mesh.vertices.size(); }
};

// One coordinate of all vertices: 0, 1 or 2 for x, y or z.
std::vector<double> coordinates(const MeshSurface&, std::size_t axis);

// The largest eigenvalue of the exchange, as stiffness() of core/stability.hpp has it for lattices: estimated from
// below by iteration, and taken a little larger.
double stiffness(const MeshSurface&);

}  // namespace pelage
