// PLY files, sound and malformed.
#include "core/error.hpp"
#include "io/mesh_file.hpp"
#include "mesh/read_ply.hpp"
#include "mesh/shapes.hpp"
#include "support/process.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

using namespace pelage;

namespace {

std::string ply_refusal(const std::string& text) {
    try {
        parse_ply(text, "a.ply");
        return "";
    } catch (const Error& error) {
        return error.what();
    }
}

const std::string vertex = "element vertex 3\nproperty float x\nproperty float y\nproperty double z\n";
const std::string face = "element face 1\nproperty list uchar int vertex_indices\n";
const std::string places = "0 0 0\n1 0 0\n0 1 0\n";

std::string ascii(const std::string& elements, const std::string& data) {
    return "ply\nformat ascii 1.0\n" + elements + "end_header\n" + data;
}
std::string data(const std::string& text) { return ascii(vertex + face, text); }

template <class T>
std::string raw(T value, bool big) {
    std::string bytes(sizeof value, '\0');
    std::memcpy(bytes.data(), &value, sizeof value);
    if (big) std::reverse(bytes.begin(), bytes.end());
    return bytes;
}

// A square with colours and an element that nobody reads, in binary.
std::string binary(bool big) {
    std::string text = std::string("ply\r\nformat binary_") + (big ? "big" : "little") +
                       "_endian 1.0\r\ncomment of a test\r\nobj_info none\r\nelement vertex 4\r\nproperty uchar red\r\n"
                       "property double x\r\nproperty float y\r\nproperty short z\r\nelement edge 1\r\n"
                       "property list ushort uint8 ends\r\nelement face 1\r\nproperty list uint8 uint vertex_index\r\n"
                       "property char flag\r\nend_header\r\n";
    const std::vector<Point> corners{{0, 0, -7}, {1, 0, 0}, {1, 0.5, 0}, {0.1, 1, 300}};
    for (const Point& p : corners) {
        text += raw<std::uint8_t>(200, big) + raw(p[0], big) + raw(static_cast<float>(p[1]), big) +
                raw(static_cast<std::int16_t>(p[2]), big);
    }
    text += raw<std::uint16_t>(2, big) + "\x01\x02" + raw<std::uint8_t>(4, big);
    for (const std::uint32_t i : {3u, 0u, 1u, 2u}) text += raw(i, big);
    return text + raw<std::int8_t>(-1, big);
}

}  // namespace

TEST_CASE("PLY files in all three forms give places and triangles") {
    const Mesh text = parse_ply(
        ascii(vertex + "property uchar red\n" + face, "0 0 0 9\n1 0 0 9 0 1 1e-3\n9\n\n 3 2 1 0 \n"), "a.ply");
    CHECK(text.vertices == std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 1e-3}});
    CHECK(text.triangles == std::vector<Triangle>{{2, 1, 0}});

    for (const bool big : {false, true}) {
        INFO(big);
        const Mesh mesh = parse_ply(binary(big), "a.ply");
        CHECK(mesh.vertices == std::vector<Point>{{0, 0, -7}, {1, 0, 0}, {1, 0.5, 0}, {0.1, 1, 300}});
        CHECK(mesh.triangles == std::vector<Triangle>{{3, 0, 1}, {3, 1, 2}});
    }
}

TEST_CASE("a malformed PLY file is refused with its place, finding and what is allowed") {
    const std::string faces_of_floats = "element face 1\nproperty list uchar float vertex_indices\n";
    const std::vector<std::pair<std::string, std::string>> wrong{
        {"", "a.ply:1: no end of this line"},
        {"ply", "a.ply:1: no end of this line"},
        {"plx\n", "a.ply:1: a PLY file begins with the line 'ply'"},
        {"v 0 0 0\n", "a.ply:1: a PLY file begins"},
        {"ply\nformat ascii 2.0\n", "a.ply:2: 'format ascii 2.0'; allowed are 'format ascii 1.0'"},
        {"ply\ncomment\n", "a.ply:2: 'comment'; allowed are"},
        {"ply\nformat ascii 1.0\n", "a.ply:3: no end of this line"},
        {"ply\nformat ascii 1.0\nvertex 3\n", "a.ply:3: 'vertex' begins a line; allowed are comment"},
        {"ply\nformat ascii 1.0\nproperty float x\n", "a.ply:3: a property stands before the first element"},
        {"ply\nformat ascii 1.0\nelement vertex\n", "a.ply:3: an element is 'element NAME COUNT'"},
        {"ply\nformat ascii 1.0\nelement vertex -1\n", "a.ply:3: an element is"},
        {"ply\nformat ascii 1.0\nelement vertex 3 3\n", "a.ply:3: an element is"},
        {"ply\nformat ascii 1.0\nelement vertex 99999999999999999999\n", "a.ply:3: an element is"},
        {"ply\nformat ascii 1.0\nelement vertex 3\nend_header\n",
         "a.ply:4: the element 'vertex' before has no property"},
        {"ply\nformat ascii 1.0\nelement vertex 3\nelement face 1\n", "a.ply:4: the element 'vertex' before has no"},
        {ascii("element vertex 3\nproperty real x\n", ""), "a.ply:4: the type 'real'; allowed are char"},
        {ascii("element vertex 3\nproperty float\n", ""), "a.ply:4: a property is 'property TYPE NAME'"},
        {ascii("element vertex 3\nproperty float x y\n", ""), "a.ply:4: a property is"},
        {ascii("element vertex 3\nproperty float x\nproperty float x\n", ""), "a.ply:5: a second property 'x'"},
        {ascii("element face 3\nproperty list float int i\n", ""), "a.ply:4: the length of a list"},
        {ascii(vertex + vertex, ""), "a.ply:7: a second element 'vertex'"},
        {ascii(vertex, places), "a.ply: no element 'face'"},
        {ascii(face, "3 0 1 2\n"), "a.ply: no element 'vertex'"},
        {ascii("element vertex 0\nproperty float x\n" + face, "3 0 1 2\n"), "a.ply: no element 'vertex'"},
        {ascii("element vertex 1\nproperty float x\nproperty float y\n" + face, "0 0\n3 0 1 2\n"),
         "a.ply: the element 'vertex' has no number 'z'"},
        {ascii("element vertex 1\nproperty list uchar int x\n" + face, "0 \n3 0 1 2\n"),
         "a.ply: the element 'vertex' has no number 'x'"},
        {ascii(vertex + "element face 1\nproperty int vertex_indices\n", places + "1\n"),
         "a.ply: the element 'face' has no list 'vertex_indices'"},
        {ascii(vertex + faces_of_floats, places + "3 0 1 2\n"), "a.ply: the element 'face' has no list"},
        {ascii("element vertex 2000000000\nproperty float x\nproperty float y\nproperty float z\n" + face, places),
         "a.ply:9: 2000000000 of element 'vertex' are announced, but 18 bytes of data hold at most 3"},
        {ascii("element nothing 4000000000000000000\nproperty list uchar int x\n" + vertex + face, places),
         "a.ply:11: 4000000000000000000 of element 'nothing'"},
        {data(places + "3 0 1 3\n"), "a.ply:13: a face names vertex 3; there are 3, counted from 0"},
        {data(places + "3 0 1 -1\n"), "a.ply:13: a face names vertex -1"},
        {data(places + "3 0 1 1.5\n"), "a.ply:13: '1.5'; allowed here is a whole number"},
        {data(places + "2 0 1\n"), "a.ply:13: a face of 2 corners; at least 3"},
        {data(places + "-1 0 1\n"), "a.ply:13: a list of -1 entries"},
        {data(places + "1000000 0 1\n"), "a.ply:13: a list of 1000000 entries, with 5 bytes left"},
        {data(places + "inf 0 1 2\n"), "a.ply:13: a list of inf entries"},
        {data(places + "3 0 1\n"), "a.ply:14: the file ends before"},
        {data("0 0 0\n1 x 0\n0 1 0\n3 0 1 2\n"), "a.ply:11: 'x'; allowed here is a number"},
        {data("0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n"), "a.ply:11: the coordinate nan"},
        {data("0 0 0\n1 0 -1e16\n0 1 0\n3 0 1 2\n"), "a.ply:11: the coordinate -1e+16"},
        {data(places + "3 0 1 2\n9\n"), "a.ply:14: 2 bytes more than"},
        {binary(false) + "x", "a.ply: byte 383: 1 bytes more than"},
        {binary(true).substr(0, 379), "a.ply: byte 379: the file ends before"},
    };
    for (const auto& [text, begin] : wrong) {
        INFO(text);
        CHECK_THAT(ply_refusal(text), Catch::Matchers::StartsWith(begin));
    }
}

TEST_CASE("a PLY file that is cut off anywhere is refused") {
    const std::string whole = binary(false);
    for (std::size_t end = 0; end < whole.size(); ++end) CHECK_FALSE(ply_refusal(whole.substr(0, end)).empty());
}

TEST_CASE("a PLY file with any one wrong byte is taken or refused") {
    for (const bool big : {false, true}) {
        const std::string whole = binary(big);
        for (std::size_t at = 0; at < whole.size(); ++at) {
            for (const char wrong : {'\0', '\xff', '1', '\n'}) {
                std::string changed = whole;
                changed[at] = wrong;
                CHECK_NOTHROW(ply_refusal(changed));
            }
        }
    }
}

TEST_CASE("a list of too many corners is refused, one that nobody reads is passed over") {
    std::string many = "1500";
    for (int i = 0; i < 1500; ++i) many += " 0";

    CHECK_THAT(ply_refusal(data(places + many)),
               Catch::Matchers::StartsWith("a.ply:13: a face of 1500 corners; at most 1000"));
    CHECK(ply_refusal(ascii(vertex + face + "property list int int more\n", places + "3 0 1 2 " + many)).empty());
}

TEST_CASE("a PLY file that is written is read again") {
    const test::Folder folder;
    const Mesh mesh = torus(7, 5);
    const std::vector<Rgb> colours(mesh.vertices.size(), Rgb{1, 2, 3});
    const std::vector<double> values(mesh.vertices.size(), 0.25);
    for (const Precision precision : {Precision::single_, Precision::double_}) {
        const auto path = folder / "a.ply";
        write_mesh_ply(path, mesh, colours, {{"conc u-v", values}}, precision);
        const std::string bytes = test::read_all(path);
        CHECK(bytes.find("property uchar red\n") != std::string::npos);
        CHECK(bytes.find(" conc_u_v\n") != std::string::npos);
        const Mesh again = parse_ply(bytes, "a.ply");
        CHECK(again.triangles == mesh.triangles);
        REQUIRE(again.vertices.size() == mesh.vertices.size());
        for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
            for (std::size_t k = 0; k < 3; ++k) {
                const double written = mesh.vertices[i][k];
                CHECK(again.vertices[i][k] ==
                      (precision == Precision::double_ ? written : static_cast<double>(static_cast<float>(written))));
            }
        }
    }
}
