// Pictures of coloured meshes.
#pragma once

#include "core/mesh.hpp"
#include "io/picture.hpp"

#include <cstddef>
#include <span>

namespace pelage {

inline constexpr std::size_t largest_view = 8192;  // pixels along a side

// A view of the mesh from far away in direction `from`, z upwards (x to the right where `from` is the z axis): all of
// it, in the middle of a white square of `size` pixels. Colours are those of the vertices, between them in proportion;
// light falls from over the viewer's left shoulder on a surface as smooth as the vertices' mean normals say. Either
// side of a triangle is lit. Throws Error when `from` is no direction, `size` is 0 or too large, or the colours are not
// one a vertex.
Picture shade(const Mesh&, std::span<const Rgb> colours, const Point& from, std::size_t size);

}  // namespace pelage
