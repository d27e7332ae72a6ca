// Surfaces of triangles: plain values, and what a simulation on their vertices needs of them.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pelage {

using Point = std::array<double, 3>;

inline Point operator+(const Point& a, const Point& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Point operator-(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Point operator*(double s, const Point& a) { return {s * a[0], s * a[1], s * a[2]}; }
inline double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Point cross(const Point& a, const Point& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double length(const Point& a) { return std::sqrt(dot(a, a)); }

using Triangle = std::array<std::uint32_t, 3>;  // places of its corners, anticlockwise as seen from outside

struct Mesh {
    std::vector<Point> vertices;
    std::vector<Triangle> triangles;

    // Twice the triangle's area, as the vector that stands on it.
    Point normal(const Triangle& t) const {
        return cross(vertices[t[1]] - vertices[t[0]], vertices[t[2]] - vertices[t[0]]);
    }
};

// What a neighbour's share of an exchange is.
enum class MeshWeights {
    uniform,   // 1: every neighbour counts alike
    cotangent  // (cot a + cot b) / 2 over the vertex's own area, a and b being the angles against the edge: the
               // Laplacian of the surface. The sum of all amounts, each times its vertex's area, is kept.
};

inline constexpr std::size_t largest_triangle_count = std::size_t{1} << 28;
inline constexpr double largest_coordinate = 1e15;  // squares of areas stay finite

}  // namespace pelage
