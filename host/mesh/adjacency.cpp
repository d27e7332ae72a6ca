// See adjacency.hpp.
#include "mesh/adjacency.hpp"

#include "core/error.hpp"
#include "mesh/edges.hpp"

#include <fmt/format.h>

namespace pelage {

namespace {

double squared(const Point& a) { return dot(a, a); }

void check_areas(const Mesh& mesh) {
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const Triangle& t = mesh.triangles[i];
        double longest = 0.0;
        for (std::size_t k = 0; k < 3; ++k)
            longest = std::max(longest, squared(mesh.vertices[t[k]] - mesh.vertices[t[(k + 1) % 3]]));
        const double twice = length(mesh.normal(t));
        if (twice > 1e-10 * longest && twice > 1e-200) continue;
        const Point& at = mesh.vertices[t[0]];
        throw Error(fmt::format(
            "a triangle at ({}, {}, {}) has no area; weights of cotangents need one, 'weights uniform' does not", at[0],
            at[1], at[2]));
    }
}

}  // namespace

std::vector<double> vertex_areas(const Mesh& mesh) {
    std::vector<double> areas(mesh.vertices.size(), 0.0);
    for (const Triangle& t : mesh.triangles) {
        const double area = length(mesh.normal(t)) / 2;
        std::array<double, 3> cotangents{};
        for (std::size_t k = 0; k < 3; ++k) cotangents[k] = area > 0.0 ? cotangent(mesh, t, k) : 0.0;
        const bool obtuse = area > 0.0 && (cotangents[0] < 0 || cotangents[1] < 0 || cotangents[2] < 0);
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t next = (k + 1) % 3, last = (k + 2) % 3;
            const Point& here = mesh.vertices[t[k]];
            areas[t[k]] += obtuse ? (cotangents[k] < 0 ? area / 2 : area / 4)
                                  : (squared(mesh.vertices[t[next]] - here) * cotangents[last] +
                                     squared(mesh.vertices[t[last]] - here) * cotangents[next]) /
                                        8;
        }
    }
    return areas;
}

Adjacency mesh_adjacency(const Mesh& mesh, MeshWeights weights) {
    const bool uniform = weights == MeshWeights::uniform;
    if (!uniform) check_areas(mesh);
    const std::vector<Edge> edges = edges_of(mesh);
    const std::vector<double> areas = uniform ? std::vector<double>() : vertex_areas(mesh);
    Adjacency result;
    result.offsets.assign(mesh.vertices.size() + 1, 0);
    for (const Edge& edge : edges) {
        ++result.offsets[edge.from + 1];
        ++result.offsets[edge.to + 1];
    }
    for (std::size_t i = 1; i < result.offsets.size(); ++i) result.offsets[i] += result.offsets[i - 1];
    result.indices.resize(result.offsets.back());
    result.weights.resize(result.offsets.back());
    std::vector<std::size_t> next(result.offsets.begin(), result.offsets.end() - 1);
    const auto put = [&](std::uint32_t cell, std::uint32_t neighbour, double cotangents) {
        const std::size_t at = next[cell]++;
        result.indices[at] = neighbour;
        result.weights[at] = uniform ? 1.0 : cotangents / 2 / areas[cell];
    };
    // Edges ascend by their ends, so that the lower neighbours of a vertex come first and all of them in order.
    for (const Edge& edge : edges) put(edge.to, edge.from, edge.cotangents);
    for (const Edge& edge : edges) put(edge.from, edge.to, edge.cotangents);
    return result;
}

}  // namespace pelage
