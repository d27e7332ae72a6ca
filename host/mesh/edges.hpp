// The edges of a mesh.
#pragma once

#include "core/mesh.hpp"

#include <cstdint>
#include <vector>

namespace pelage {

struct Edge {
    std::uint32_t from = 0;
    std::uint32_t to = 0;  // greater than from
    std::uint32_t triangles = 0;
    double cotangents = 0.0;  // of the angles that lie against it, added up in the order of the triangles
};

// Each once, ascending by from and to.
std::vector<Edge> edges_of(const Mesh&);

// Of the angle at corner `k` of a triangle.
double cotangent(const Mesh&, const Triangle&, std::size_t k);

}  // namespace pelage
