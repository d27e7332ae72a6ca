// OBJ files, sound and malformed.
#include "core/error.hpp"
#include "mesh/read_obj.hpp"

#include <catch2/catch.hpp>

#include <string>
#include <utility>
#include <vector>

using namespace pelage;

namespace {

const std::string corner = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

std::string obj_refusal(const std::string& text) {
    try {
        parse_obj(text, "a.obj");
        return "";
    } catch (const Error& error) {
        return error.what();
    }
}

}  // namespace

TEST_CASE("an OBJ file gives places and triangles") {
    const Mesh mesh = parse_obj(
        "# a square and a corner\r\nmtllib a.mtl\r\no part\r\nv 0 0 0\r\nv 1 0 0 1.0\r\nv 1 1 0 0.5 0.5 0.5\r\n"
        "v 0 1 +2.5e-1\r\nvt 0 0\r\nvn 0 0 1\r\ng side\r\ns off\r\nusemtl skin\r\nf 1/1/1 2/1/1 3//1 4/1 # all\r\nf -4 "
        "-3 -1\r\n",
        "a.obj");

    REQUIRE(mesh.vertices.size() == 4);
    CHECK(mesh.vertices[3] == Point{0, 1, 0.25});
    CHECK(mesh.triangles == std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}, {0, 1, 3}});
}

TEST_CASE("coordinates of an OBJ file are read to the last bit") {
    const Mesh mesh = parse_obj("v 0.1 1e-300 123456789.123456789\nv 1 0 0\nv 0 1 0\nf 1 2 3", "a.obj");

    CHECK(mesh.vertices[0] == Point{0.1, 1e-300, 123456789.123456789});
}

TEST_CASE("a malformed OBJ file is refused with line, finding and what is allowed") {
    const std::vector<std::pair<std::string, std::string>> wrong{
        {"", "a.obj: no vertex"},
        {"# nothing\n", "a.obj: no vertex"},
        {corner, "a.obj: no face"},
        {"v 1 2\n", "a.obj:1: a vertex of 2 numbers"},
        {"v\n", "a.obj:1: a vertex of 0 numbers"},
        {"v 1 2 3 4 5\n", "a.obj:1: a vertex of 5 numbers"},
        {"v 1 2 3 4 5 6 7 8\n", "a.obj:1: a vertex of 8 numbers"},
        {"v 1 abc 2\n", "a.obj:1: 'abc' in a vertex; allowed are numbers"},
        {"v 1 2 3x\n", "a.obj:1: '3x' in a vertex"},
        {"v 1 2 +-3\n", "a.obj:1: '+-3' in a vertex"},
        {"v 1 2 1e999\n", "a.obj:1: '1e999' in a vertex"},
        {"v nan 0 0\n", "a.obj:1: the coordinate nan"},
        {"v 0 inf 0\n", "a.obj:1: the coordinate inf"},
        {"v 0 0 1e16\n", "a.obj:1: the coordinate 1e+16"},
        {corner + "f 1 2\n", "a.obj:4: a face of 2 corners; at least 3"},
        {corner + "f\n", "a.obj:4: a face of 0 corners"},
        {corner + "f 1 2 4\n", "a.obj:4: a face names vertex 4; 3 vertices stand before it"},
        {corner + "f 0 1 2\n", "a.obj:4: a face names vertex 0"},
        {corner + "f 1 2 -4\n", "a.obj:4: a face names vertex -4"},
        {corner + "f 1 2 99999999999999999999\n", "a.obj:4: the corner '99999999999999999999'"},
        {corner + "f 1 2 x\n", "a.obj:4: the corner 'x' of a face; allowed are V, V/T, V//N and V/T/N"},
        {corner + "f 1 2 3/\n", "a.obj:4: the corner '3/'"},
        {corner + "f 1 2 3//\n", "a.obj:4: the corner '3//'"},
        {corner + "f 1 2 3/1/\n", "a.obj:4: the corner '3/1/'"},
        {corner + "f 1 2 3/1/1/1\n", "a.obj:4: the corner '3/1/1/1'"},
        {corner + "f 1 2 /3\n", "a.obj:4: the corner '/3'"},
        {corner + "f 1 2 3.0\n", "a.obj:4: the corner '3.0'"},
        {"f 1 2 3\n" + corner, "a.obj:1: a face names vertex 1; 0 vertices"},
        {corner + "face 1 2 3\n", "a.obj:4: 'face' begins a line; allowed are v, f"},
        {corner + "curv 0 1 1 2\n", "a.obj:4: 'curv' begins a line"},
        {"ply\n", "a.obj:1: 'ply' begins a line"},
        {std::string("\0\x01\xff", 3), "a.obj:1: '?\?\?' begins a line"},
        {"v 0 0 0\rv 1 0 0\rv 0 1\r", "a.obj:3: a vertex of 2 numbers"},
        {corner + "f 1 2 3 \\\n", "a.obj:4: the corner '\\'"},
    };
    for (const auto& [text, begin] : wrong) {
        INFO(text);
        CHECK_THAT(obj_refusal(text), Catch::Matchers::StartsWith(begin));
    }
}

TEST_CASE("a face of too many corners is refused") {
    std::string face = corner + "f";
    for (int i = 0; i < 1001; ++i) face += " 1";

    CHECK_THAT(obj_refusal(face), Catch::Matchers::StartsWith("a.obj:4: a face of 1001 corners; at most 1000"));
    face.resize(face.size() - 2);
    CHECK(obj_refusal(face).empty());
}
