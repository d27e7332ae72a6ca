// Meshes with values on their vertices, for other programs.
#pragma once

#include "core/mesh.hpp"
#include "core/precision.hpp"
#include "io/picture.hpp"

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace pelage {

struct VertexValues {
    std::string name;
    std::span<const double> values;  // one a vertex
};

// .ply, binary little-endian, as Blender and MeshLab read it: x, y, z, then red, green and blue where there are
// colours, then the values under names of letters, digits and '_'; faces as lists of three. Throws Error when the file
// cannot be written.
void write_mesh_ply(const std::filesystem::path&, const Mesh&, std::span<const Rgb> colours,
                    const std::vector<VertexValues>&, Precision);

// .vtp: PolyData of polygons, the values as point data; "TimeValue" is `time`. Throws Error as above.
void write_mesh_vtp(const std::filesystem::path&, const Mesh&, const std::vector<VertexValues>&, double time,
                    std::uint64_t iteration, Precision);

}  // namespace pelage
