// Builds a mesh face by face, for the readers of files.
#pragma once

#include "core/mesh.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace pelage {

inline constexpr std::size_t largest_polygon = 1000;  // corners

// Adds a polygon as a fan of triangles around its first corner. Returns what is wrong with it, empty where nothing is:
// fewer than 3 corners, more than largest_polygon, or too many triangles in all.
std::string add_polygon(Mesh&, const std::vector<std::uint32_t>& corners);

// Why a coordinate cannot be taken; empty where it can: finite, within largest_coordinate.
std::string coordinate_fault(double);

}  // namespace pelage
