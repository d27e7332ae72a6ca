// Meshes made by rule, their tidying, their adjacency.
#include "core/error.hpp"
#include "mesh/adjacency.hpp"
#include "mesh/edges.hpp"
#include "mesh/locality.hpp"
#include "mesh/shapes.hpp"
#include "mesh/tidy.hpp"
#include "support/process.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <numbers>
#include <numeric>

using namespace pelage;

namespace {

double area(const Mesh& mesh) {
    double sum = 0.0;
    for (const Triangle& t : mesh.triangles) sum += length(mesh.normal(t)) / 2;
    return sum;
}

// Vertices - edges + triangles.
long euler(const Mesh& mesh) {
    return static_cast<long>(mesh.vertices.size()) - static_cast<long>(edges_of(mesh).size()) +
           static_cast<long>(mesh.triangles.size());
}

bool closed(const Mesh& mesh) {
    return std::ranges::all_of(edges_of(mesh), [](const Edge& e) { return e.triangles == 2; });
}

double volume(const Mesh& mesh) {  // above 0 where triangles run anticlockwise as seen from outside
    double sum = 0.0;
    for (const auto& [a, b, c] : mesh.triangles)
        sum += dot(mesh.vertices[a], cross(mesh.vertices[b], mesh.vertices[c])) / 6;
    return sum;
}

double sum_of(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

std::string tidy_refusal(Mesh mesh) {
    try {
        tidy(mesh);
        return "";
    } catch (const Error& error) {
        return error.what();
    }
}

}  // namespace

TEST_CASE("an icosphere is a closed sphere of one unit of area a vertex") {
    for (const std::size_t n : {0u, 1u, 2u, 4u}) {
        INFO(n);
        const Mesh mesh = icosphere(n);
        const std::size_t times = std::size_t{1} << (2 * n);
        REQUIRE(mesh.vertices.size() == 10 * times + 2);
        CHECK(mesh.triangles.size() == 20 * times);
        CHECK(euler(mesh) == 2);
        CHECK(closed(mesh));
        CHECK(volume(mesh) > 0);
        const auto vertices = static_cast<double>(mesh.vertices.size());
        const double radius = std::sqrt(vertices / (4 * std::numbers::pi));
        for (const Point& vertex : mesh.vertices) CHECK(length(vertex) == Approx(radius).epsilon(1e-12));
        CHECK(area(mesh) < vertices);
        if (n > 0) CHECK(area(mesh) > vertices * (1 - 0.75 / static_cast<double>(times)));
    }
    CHECK_THROWS_AS(icosphere(11), Error);
}

TEST_CASE("a torus is closed, has no pole, and one unit of area a vertex") {
    const Mesh mesh = torus(40, 20);

    CHECK(mesh.vertices.size() == 800);
    CHECK(euler(mesh) == 0);
    CHECK(closed(mesh));
    CHECK(volume(mesh) > 0);
    CHECK(area(mesh) == Approx(800).epsilon(0.02));
    CHECK(area(torus(160, 80)) == Approx(12800).epsilon(0.002));
    CHECK_THROWS_AS(torus(20, 20), Error);
    CHECK_THROWS_AS(torus(20, 2), Error);
    CHECK_THROWS_AS(torus(100'000'000, 1000), Error);
}

TEST_CASE("areas of vertices add up to the area of the mesh") {
    for (const Mesh& mesh : {icosphere(3), torus(12, 5), sheet(5, 4)}) {
        const std::vector<double> areas = vertex_areas(mesh);
        CHECK(sum_of(areas) == Approx(area(mesh)).epsilon(1e-12));
        CHECK(std::ranges::all_of(areas, [](double a) { return a > 0; }));
    }
    const Mesh obtuse{{{0, 0, 0}, {4, 0, 0}, {2, 0.5, 0}}, {{0, 1, 2}}};
    CHECK(vertex_areas(obtuse) == std::vector<double>{0.25, 0.25, 0.5});
}

TEST_CASE("neighbours of a mesh ascend, and each is the neighbour of its own") {
    const Adjacency adjacency = mesh_adjacency(icosphere(2), MeshWeights::uniform);

    REQUIRE(adjacency.cells() == 162);
    for (std::size_t cell = 0; cell < adjacency.cells(); ++cell) {
        const auto first = adjacency.indices.begin() + static_cast<std::ptrdiff_t>(adjacency.offsets[cell]);
        const auto last = adjacency.indices.begin() + static_cast<std::ptrdiff_t>(adjacency.offsets[cell + 1]);
        CHECK(std::is_sorted(first, last));
        CHECK(last - first == (cell < 12 ? 5 : 6));
        for (auto at = first; at != last; ++at) {
            const auto begin = adjacency.indices.begin() + static_cast<std::ptrdiff_t>(adjacency.offsets[*at]);
            const auto end = adjacency.indices.begin() + static_cast<std::ptrdiff_t>(adjacency.offsets[*at + 1]);
            CHECK(std::binary_search(begin, end, static_cast<std::uint32_t>(cell)));
        }
    }
    CHECK(std::ranges::all_of(adjacency.weights, [](double w) { return w == 1.0; }));
}

TEST_CASE("cotangent weights of a flat grid are the five-point stencil") {
    constexpr std::size_t columns = 6, rows = 5;
    const Adjacency adjacency = mesh_adjacency(sheet(columns, rows), MeshWeights::cotangent);
    for (std::size_t row = 1; row + 1 < rows; ++row) {
        for (std::size_t column = 1; column + 1 < columns; ++column) {
            const std::size_t cell = row * columns + column;
            for (std::size_t entry = adjacency.offsets[cell]; entry < adjacency.offsets[cell + 1]; ++entry) {
                const std::size_t other = adjacency.indices[entry];
                const bool beside =
                    other + 1 == cell || other == cell + 1 || other + columns == cell || other == cell + columns;
                CHECK(adjacency.weights[entry] == Approx(beside ? 1.0 : 0.0).margin(1e-15));
            }
        }
    }
}

TEST_CASE("exchange by cotangents keeps the sum of amounts times areas") {
    const Mesh mesh = torus(14, 6);
    const Adjacency adjacency = mesh_adjacency(mesh, MeshWeights::cotangent);
    const std::vector<double> areas = vertex_areas(mesh);
    double whole = 0.0, moved = 0.0;
    for (std::size_t cell = 0; cell < adjacency.cells(); ++cell) {
        for (std::size_t entry = adjacency.offsets[cell]; entry < adjacency.offsets[cell + 1]; ++entry) {
            const double step =
                adjacency.weights[entry] * (std::sin(adjacency.indices[entry]) - std::sin(double(cell)));
            whole += areas[cell] * step;
            moved += std::abs(areas[cell] * step);
        }
    }
    CHECK(std::abs(whole) < 1e-12 * moved);
}

TEST_CASE("a triangle without area has no cotangents") {
    const Mesh line{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 1, 3}}};

    CHECK_NOTHROW(mesh_adjacency(line, MeshWeights::uniform));
    CHECK_THROWS_WITH(mesh_adjacency(line, MeshWeights::cotangent), Catch::Contains("has no area"));
}

TEST_CASE("tidying joins, leaves out and tells") {
    Mesh mesh{{{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {5, 5, 5}},
              {{1, 2, 3}, {4, 5, 6}, {3, 4, 5}, {1, 5, 2}}};
    const std::vector<std::string> notes = tidy(mesh);

    CHECK(mesh.vertices == std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}});
    CHECK(mesh.triangles == std::vector<Triangle>{{0, 1, 2}, {0, 1, 3}});
    CHECK(notes == std::vector<std::string>{"2 vertices at the very place of another: joined",
                                            "1 triangle with two corners in one place: left out",
                                            "1 triangle on the corners of another: left out",
                                            "2 vertices that no triangle names: left out"});
    CHECK(tidy(mesh).empty());
}

TEST_CASE("tidying keeps edges of more than two triangles, and says so") {
    Mesh book{{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}}, {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}};

    CHECK(tidy(book) == std::vector<std::string>{"1 edge of more than two triangles: kept"});
    CHECK(book.triangles.size() == 3);
}

TEST_CASE("a mesh of which nothing is left is refused") {
    CHECK_THAT(tidy_refusal({{{0, 0, 0}, {0, 0, 0}, {1, 0, 0}}, {{0, 1, 2}}}), Catch::Contains("no triangle"));
    CHECK_THAT(tidy_refusal({}), Catch::Contains("no triangle"));
}

TEST_CASE("the order for caches is a permutation that brings neighbours together") {
    const Adjacency adjacency = mesh_adjacency(icosphere(4), MeshWeights::uniform);
    std::vector<std::uint32_t> as_it_is(adjacency.cells());
    std::iota(as_it_is.begin(), as_it_is.end(), 0u);
    std::vector<std::uint32_t> order = locality_order(adjacency);

    CHECK(bandwidth(adjacency, order) < 200);
    CHECK(bandwidth(adjacency, as_it_is) > 2000);
    std::ranges::sort(order);
    CHECK(order == as_it_is);
}
