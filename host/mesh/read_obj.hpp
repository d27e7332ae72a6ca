// Wavefront OBJ files to meshes.
#pragma once

#include "core/mesh.hpp"

#include <string>
#include <string_view>

namespace pelage {

// Takes places of vertices and faces; texture coordinates, normals, colours, names, materials, points and lines are
// passed over. Polygons are cut into a fan from their first corner. Numbers are read to the last bit, and whatever is
// not understood is refused: throws Error with `name`, the line, what was found and what is allowed.
Mesh parse_obj(std::string_view bytes, const std::string& name);

}  // namespace pelage
