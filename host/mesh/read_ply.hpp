// PLY files to meshes: ASCII, and binary in either order of bytes.
#pragma once

#include "core/mesh.hpp"

#include <string>
#include <string_view>

namespace pelage {

// Takes x, y, z of the element `vertex` and the list `vertex_indices` (or `vertex_index`) of `face`; all other
// properties and elements are passed over. Polygons are cut into a fan from their first corner. Counts are held against
// the size of the file before memory is taken. Throws Error with `name`, the line (in binary data the byte), what was
// found and what is allowed.
Mesh parse_ply(std::string_view bytes, const std::string& name);

}  // namespace pelage
