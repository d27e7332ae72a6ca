// Fuzzer of the readers of meshes: any bytes must give a mesh whose triangles name its vertices, or an Error that names
// the file; and what is made of a mesh must bear every one.
#include "core/error.hpp"
#include "io/shade.hpp"
#include "mesh/adjacency.hpp"
#include "mesh/locality.hpp"
#include "mesh/read_obj.hpp"
#include "mesh/read_ply.hpp"
#include "mesh/tidy.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

namespace {

void check_mesh(const pelage::Mesh& mesh) {
    for (const pelage::Point& vertex : mesh.vertices) {
        for (const double coordinate : vertex) {
            if (!std::isfinite(coordinate)) std::abort();
        }
    }
    for (const pelage::Triangle& triangle : mesh.triangles) {
        for (const std::uint32_t corner : triangle) {
            if (corner >= mesh.vertices.size()) std::abort();
        }
    }
    if (mesh.triangles.empty()) std::abort();
}

void use(pelage::Mesh mesh) {
    tidy(mesh);
    check_mesh(mesh);
    const pelage::Adjacency adjacency = mesh_adjacency(mesh, pelage::MeshWeights::uniform);
    if (locality_order(adjacency).size() != mesh.vertices.size()) std::abort();
    const std::vector<pelage::Rgb> colours(mesh.vertices.size(), pelage::Rgb{1, 2, 3});
    shade(mesh, colours, {1, 2, 3}, 8);
    for (const double weight : mesh_adjacency(mesh, pelage::MeshWeights::cotangent).weights) {
        if (!std::isfinite(weight)) std::abort();
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    pelage::Mesh mesh;
    try {
        mesh = bytes.starts_with("ply") ? pelage::parse_ply(bytes, "fuzz.mesh") : pelage::parse_obj(bytes, "fuzz.mesh");
        check_mesh(mesh);
    } catch (const pelage::Error& error) {
        if (std::string_view(error.what()).find("fuzz.mesh:") != 0) std::abort();
        return 0;
    }
    try {
        use(std::move(mesh));
    } catch (const pelage::Error&) {  // nothing is left, or a triangle has no area
    }
    return 0;
}
