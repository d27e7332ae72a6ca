// Shaded views, and surfaces for VTK.
#include "core/error.hpp"
#include "io/mesh_file.hpp"
#include "io/shade.hpp"
#include "mesh/shapes.hpp"
#include "support/process.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

using namespace pelage;

namespace {

constexpr Rgb white{255, 255, 255};

std::vector<Rgb> painted(const Mesh& mesh, Rgb colour) { return std::vector<Rgb>(mesh.vertices.size(), colour); }

}  // namespace

TEST_CASE("the view of a sphere is a disc on white, brightest towards the light") {
    const Mesh mesh = icosphere(4);
    const Picture picture = shade(mesh, painted(mesh, {200, 100, 50}), {1, 0, 0}, 100);

    REQUIRE(picture.columns == 100);
    REQUIRE(picture.rows == 100);
    std::size_t inside = 0;
    for (const Rgb& pixel : picture.pixels) inside += pixel != white ? 1 : 0;
    const double disc = 3.14159 * 46 * 46;
    CHECK(static_cast<double>(inside) == Approx(disc).epsilon(0.03));
    for (const std::size_t corner : {0u, 99u, 9900u, 9999u}) CHECK(picture.pixels[corner] == white);
    CHECK(picture.at(35, 30)[0] > picture.at(70, 75)[0] + 40);
    CHECK(picture.at(50, 50)[0] > picture.at(50, 50)[1]);
}

TEST_CASE("what is nearer hides what is farther, from every side") {
    Mesh two{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 1}, {4, 0, 1}, {0, 4, 1}}, {{0, 1, 2}, {5, 4, 3}}};
    std::vector<Rgb> colours(6, Rgb{255, 0, 0});
    for (std::size_t i = 3; i < 6; ++i) colours[i] = {0, 0, 255};

    const Picture above = shade(two, colours, {0, 0, 1}, 40);
    const Picture below = shade(two, colours, {0, 0, -1}, 40);
    CHECK(above.at(12, 28)[2] > 100);
    CHECK(above.at(12, 28)[0] == 0);
    std::size_t red = 0;
    for (const Rgb& pixel : below.pixels) red += pixel != white && pixel[2] == 0 ? 1 : 0;
    CHECK(red > 300);
}

TEST_CASE("colours between vertices are mixed of theirs") {
    const Mesh flat = sheet(2, 2);
    const Picture picture =
        shade(flat, std::vector<Rgb>{{0, 0, 0}, {200, 0, 0}, {0, 0, 0}, {200, 0, 0}}, {0, 0, 1}, 50);

    CHECK(picture.at(5, 25)[0] < picture.at(25, 25)[0]);
    CHECK(picture.at(25, 25)[0] < picture.at(44, 25)[0]);
}

TEST_CASE("a view that cannot be is refused") {
    const Mesh mesh = sheet(2, 2);
    const std::vector<Rgb> colours = painted(mesh, white);

    CHECK_THROWS_AS(shade(mesh, colours, {0, 0, 0}, 10), Error);
    CHECK_THROWS_AS(shade(mesh, colours, {std::numeric_limits<double>::infinity(), 0, 0}, 10), Error);
    CHECK_THROWS_AS(shade(mesh, colours, {0, 0, 1}, 0), Error);
    CHECK_THROWS_AS(shade(mesh, colours, {0, 0, 1}, 100'000), Error);
    CHECK_THROWS_AS(shade(mesh, std::span(colours).first(3), {0, 0, 1}, 10), Error);
}

TEST_CASE("a mesh without extent is a white picture") {
    const Mesh point{{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, {{0, 1, 2}}};
    const Picture picture = shade(point, painted(point, {0, 0, 0}), {1, 1, 1}, 10);

    for (const Rgb& pixel : picture.pixels) CHECK(pixel == white);
}

TEST_CASE("a surface for VTK has its points, triangles and values") {
    const test::Folder folder;
    const Mesh mesh = sheet(3, 2);
    const std::vector<double> values(6, 0.5);
    write_mesh_vtp(folder / "a.vtp", mesh, {{"conc U", values}}, 2.5, 10, Precision::single_);
    const std::string text = test::read_all(folder / "a.vtp");

    CHECK(text.find("NumberOfPoints=\"6\"") != std::string::npos);
    CHECK(text.find("NumberOfPolys=\"4\"") != std::string::npos);
    CHECK(text.find("Name=\"conc U\"") != std::string::npos);
    CHECK(text.find("Name=\"connectivity\"") != std::string::npos);
}
