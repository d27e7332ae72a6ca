// See shapes.hpp.
#include "mesh/shapes.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <unordered_map>

namespace pelage {

namespace {

Mesh icosahedron() {
    const double g = std::numbers::phi;
    return {{{-1, g, 0},
             {1, g, 0},
             {-1, -g, 0},
             {1, -g, 0},
             {0, -1, g},
             {0, 1, g},
             {0, -1, -g},
             {0, 1, -g},
             {g, 0, -1},
             {g, 0, 1},
             {-g, 0, -1},
             {-g, 0, 1}},
            {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
             {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
             {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
}

Point unit(const Point& p) { return (1.0 / length(p)) * p; }

// Each triangle in four; edges that two triangles share get one vertex.
void cut_in_four(Mesh& mesh) {
    std::unordered_map<std::uint64_t, std::uint32_t> middles;
    middles.reserve(mesh.triangles.size() * 3 / 2);
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
        const std::uint64_t key = (std::uint64_t{std::min(a, b)} << 32) | std::max(a, b);
        const auto [at, made] = middles.try_emplace(key, static_cast<std::uint32_t>(mesh.vertices.size()));
        if (made) mesh.vertices.push_back(unit(mesh.vertices[a] + mesh.vertices[b]));
        return at->second;
    };
    std::vector<Triangle> finer;
    finer.reserve(4 * mesh.triangles.size());
    for (const auto& [a, b, c] : mesh.triangles) {
        const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
        finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    mesh.triangles = std::move(finer);
}

void cut_square(Mesh& mesh, std::size_t a, std::size_t b, std::size_t c, std::size_t d) {
    const auto place = [](std::size_t i) { return static_cast<std::uint32_t>(i); };
    mesh.triangles.push_back({place(a), place(b), place(c)});
    mesh.triangles.push_back({place(a), place(c), place(d)});
}

void check_size(std::size_t lines, std::size_t each, const char* shape) {
    if (lines > largest_shape_count / each)
        throw Error(
            fmt::format("a {} of {} x {}; at most {} vertices are allowed", shape, lines, each, largest_shape_count));
}

}  // namespace

Mesh icosphere(std::size_t subdivisions) {
    if (subdivisions > largest_icosphere)
        throw Error(
            fmt::format("an icosphere of {} subdivisions; allowed are 0 to {}", subdivisions, largest_icosphere));
    Mesh mesh = icosahedron();
    for (Point& vertex : mesh.vertices) vertex = unit(vertex);
    for (std::size_t i = 0; i < subdivisions; ++i) cut_in_four(mesh);
    const double radius = std::sqrt(static_cast<double>(mesh.vertices.size()) / (4 * std::numbers::pi));
    for (Point& vertex : mesh.vertices) vertex = radius * vertex;
    return mesh;
}

Mesh torus(std::size_t around, std::size_t across) {
    if (across < 3 || around <= across)
        throw Error(
            fmt::format("a torus of {} around and {} across; at least 3 across are needed, and more around than "
                        "across, or it would run into itself",
                        around, across));
    check_size(around, across, "torus");
    constexpr double turn = 2 * std::numbers::pi;
    const double ring = static_cast<double>(around) / turn;
    const double tube = static_cast<double>(across) / turn;
    Mesh mesh;
    mesh.vertices.reserve(around * across);
    mesh.triangles.reserve(2 * around * across);
    for (std::size_t i = 0; i < around; ++i) {
        const double u = turn * static_cast<double>(i) / static_cast<double>(around);
        for (std::size_t j = 0; j < across; ++j) {
            const double v = turn * static_cast<double>(j) / static_cast<double>(across);
            const double from_axis = ring + tube * std::cos(v);
            mesh.vertices.push_back({from_axis * std::cos(u), from_axis * std::sin(u), tube * std::sin(v)});
            const std::size_t next = (i + 1) % around * across, here = i * across, up = (j + 1) % across;
            cut_square(mesh, here + j, next + j, next + up, here + up);
        }
    }
    return mesh;
}

Mesh sheet(std::size_t columns, std::size_t rows) {
    if (columns < 2 || rows < 2)
        throw Error(fmt::format("a sheet of {} x {}; at least 2 x 2 are needed", columns, rows));
    check_size(rows, columns, "sheet");
    Mesh mesh;
    for (std::size_t row = 0; row < rows; ++row) {
        for (std::size_t column = 0; column < columns; ++column) {
            mesh.vertices.push_back({static_cast<double>(column), static_cast<double>(row), 0.0});
            const std::size_t at = row * columns + column;
            if (row > 0 && column > 0) cut_square(mesh, at - columns - 1, at - columns, at, at - 1);
        }
    }
    return mesh;
}

}  // namespace pelage
