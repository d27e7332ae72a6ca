// Who is whose neighbour on a mesh, and how much room each vertex has.
#pragma once

#include "core/adjacency.hpp"
#include "core/mesh.hpp"

#include <vector>

namespace pelage {

// Of each vertex its share of the triangles around it: the part nearer to it than to their other corners, and of a
// triangle with an obtuse angle half of it to the obtuse corner and a quarter to either other (Meyer, Desbrun,
// Schroeder & Barr 2003). They add up to the area of the mesh.
std::vector<double> vertex_areas(const Mesh&);

// Vertices that share an edge are neighbours; ascending. Throws Error when MeshWeights::cotangent meets a triangle
// without area.
Adjacency mesh_adjacency(const Mesh&, MeshWeights);

}  // namespace pelage
