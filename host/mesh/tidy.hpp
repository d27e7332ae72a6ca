// What files of meshes hold that no simulation can use, put right.
#pragma once

#include "core/mesh.hpp"

#include <string>
#include <vector>

namespace pelage {

// In this order:
//   - vertices at the very same place become the first of them (files split vertices along seams of textures);
//   - triangles with two corners in one vertex are left out, and all but the first of those on the same three vertices;
//   - vertices that no triangle names are left out; the others keep their order.
// Edges of more than two triangles stay, and exchange along them does. Returns a sentence for each kind that was found,
// the edges among them. Throws Error when no triangle is left.
std::vector<std::string> tidy(Mesh&);

}  // namespace pelage
