// See edges.hpp.
#include "mesh/edges.hpp"

#include <algorithm>

namespace pelage {

double cotangent(const Mesh& mesh, const Triangle& t, std::size_t k) {
    const Point& corner = mesh.vertices[t[k]];
    const Point a = mesh.vertices[t[(k + 1) % 3]] - corner;
    const Point b = mesh.vertices[t[(k + 2) % 3]] - corner;
    return dot(a, b) / length(cross(a, b));
}

std::vector<Edge> edges_of(const Mesh& mesh) {
    std::vector<Edge> all;
    all.reserve(3 * mesh.triangles.size());
    for (const Triangle& t : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [from, to] = std::minmax(t[(k + 1) % 3], t[(k + 2) % 3]);
            all.push_back({from, to, 1, cotangent(mesh, t, k)});
        }
    }
    const auto key = [](const Edge& e) { return (std::uint64_t{e.from} << 32) | e.to; };
    std::ranges::stable_sort(all, {}, key);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (kept > 0 && key(all[kept - 1]) == key(all[i])) {
            all[kept - 1].triangles += 1;
            all[kept - 1].cotangents += all[i].cotangents;
        } else {
            all[kept++] = all[i];
        }
    }
    all.resize(kept);
    return all;
}

}  // namespace pelage
