// Meshes made by rule.
#pragma once

#include "core/mesh.hpp"

#include <cstddef>

namespace pelage {

inline constexpr std::size_t largest_shape_count = 4'000'000;  // vertices of a mesh made by rule
inline constexpr std::size_t largest_icosphere = 9;            // subdivisions: 2 621 442 vertices

// A sphere: an icosahedron whose triangles are cut in four `subdivisions` times, all vertices on the sphere:
// 10 * 4^subdivisions + 2 of them. Its area is one unit a vertex, as that of a matrix is one a cell: the radius is
// sqrt(vertices / (4 pi)). Throws Error above largest_icosphere.
Mesh icosphere(std::size_t subdivisions);

// A torus around the z axis, its vertices in `around` sections of `across` each: vertex j of section i is i * across +
// j. Its middle line is `around` long and its tube `across` round, so that its area is one unit a vertex, too. Squares
// are cut in two triangles each. Throws Error unless 3 <= across < around and there are at most largest_shape_count
// vertices.
Mesh torus(std::size_t around, std::size_t across);

// A flat sheet of columns x rows vertices one unit apart, at height 0; vertex = row * columns + column. Squares are cut
// in two. Throws Error unless both are at least 2, and as above.
Mesh sheet(std::size_t columns, std::size_t rows);

}  // namespace pelage
