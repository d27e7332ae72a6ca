// VTK files: well-formed XML, the right counts, and the numbers themselves.
#include "io/vtk.hpp"
#include "core/error.hpp"
#include "io/vtk_xml.hpp"
#include "scratch.hpp"

#include <catch2/catch.hpp>
#include <cstring>
#include <map>
#include <string>

using Catch::Matchers::Contains;
using namespace pelage;
using test::Scratch;

namespace {

struct Array {
    std::string type;
    std::string components;
    std::string bytes;
};

// What one of our VTK files holds; `problem` says why it is not well-formed.
struct Document {
    std::map<std::string, std::map<std::string, std::string>> elements;  // attributes by tag; the last one wins
    std::map<std::string, Array> arrays;
    std::string problem;
};

std::string decoded(const std::string& letters) {
    static const std::string alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    unsigned bits = 0;
    int filled = 0;
    for (const char letter : letters) {
        if (letter == '=' || letter == '\n') continue;
        bits = bits << 6 | static_cast<unsigned>(alphabet.find(letter));
        filled += 6;
        if (filled < 8) continue;
        filled -= 8;
        bytes += static_cast<char>(bits >> filled & 0xff);
    }
    return bytes;
}

std::map<std::string, std::string> attributes_of(const std::string& tag) {
    std::map<std::string, std::string> attributes;
    for (auto at = tag.find('='); at != tag.npos; at = tag.find('=', tag.find('"', at + 2))) {
        const auto name = tag.rfind(' ', at) + 1;
        attributes[tag.substr(name, at - name)] = tag.substr(at + 2, tag.find('"', at + 2) - at - 2);
    }
    return attributes;
}

Document parse_document(const std::string& text) {
    Document document;
    std::vector<std::string> open;
    std::size_t at = 0;
    while (at < text.size()) {
        const auto begin = text.find('<', at);
        if (begin == text.npos) break;
        const auto end = text.find('>', begin);
        if (end == text.npos) return document.problem = "an open tag", document;
        const auto tag = text.substr(begin + 1, end - begin - 1);
        at = end + 1;
        if (tag[0] == '?') continue;
        if (tag[0] == '/') {
            if (open.empty() || open.back() != tag.substr(1)) return document.problem = "wrong end " + tag, document;
            open.pop_back();
            continue;
        }
        const auto name = tag.substr(0, tag.find(' '));
        open.push_back(name);
        const auto attributes = attributes_of(tag);
        document.elements[name] = attributes;
        if (name != "DataArray" || attributes.at("format") != "binary") continue;
        document.arrays[attributes.at("Name")] = {attributes.at("type"), attributes.at("NumberOfComponents"),
                                                  decoded(text.substr(at, text.find('<', at) - at))};
    }
    if (!open.empty()) document.problem = open.back() + " is not closed";
    return document;
}

// The numbers of an array, after its length in bytes.
template <class T>
std::vector<T> numbers(const Array& array) {
    std::uint64_t length = 0;
    REQUIRE(array.bytes.size() >= 8);
    std::memcpy(&length, array.bytes.data(), 8);
    REQUIRE(length == array.bytes.size() - 8);
    std::vector<T> values(length / sizeof(T));
    std::memcpy(values.data(), array.bytes.data() + 8, length);
    return values;
}

}  // namespace

TEST_CASE("a lattice as .vti: shape, place and values") {
    const Scratch scratch;
    auto lattice = test::lattice(3, 2);
    lattice.origin_x = 10;

    write_vti(scratch / "a.vti", lattice, test::experiment(), Precision::single_);
    auto document = parse_document(test::get(scratch / "a.vti"));

    CHECK(document.problem.empty());
    CHECK(document.elements["VTKFile"]["type"] == "ImageData");
    CHECK(document.elements["VTKFile"]["header_type"] == "UInt64");
    CHECK(document.elements["ImageData"]["WholeExtent"] == "0 3 0 2 0 0");
    CHECK(document.elements["Piece"]["Extent"] == "0 3 0 2 0 0");
    CHECK(document.elements["ImageData"]["Origin"] == "3.5 -1 0");
    CHECK(document.elements["ImageData"]["Spacing"] == "1 1 1");
    CHECK(document.arrays.size() == 2);
    CHECK(document.arrays["U"].type == "Float32");
    CHECK(numbers<float>(document.arrays["U"]) == std::vector<float>{0.5, 1.5, 2.5, 3.5, 4.5, 5.5});
    CHECK(numbers<float>(document.arrays["V"])[5] == -1.25f);
}

TEST_CASE("the time of VTK files is the simulated one, through phases of different time steps") {
    const Scratch scratch;
    auto experiment = test::experiment();
    experiment.phases[0].time_step = 0.25;  // iterations 0 to 99
    experiment.phases[1].time_step = 2.0;
    auto lattice = test::lattice(3, 2);
    auto cells = test::cells({0, 2}, {0, 0});
    lattice.iteration = 110;

    write_vti(scratch / "a.vti", lattice, experiment, Precision::single_);
    write_vtp(scratch / "a.vtp", cells, experiment, Precision::single_);

    const auto field = [](const std::string& name, const std::string& value) {
        return Contains("Name=\"" + name + "\" NumberOfTuples=\"1\" format=\"ascii\">" + value + "<");
    };
    CHECK_THAT(test::get(scratch / "a.vti"), field("TimeValue", "45") && field("iteration", "110"));
    CHECK_THAT(test::get(scratch / "a.vtp"), field("TimeValue", "10.5") && field("iteration", "42"));
}

TEST_CASE("a double run's .vti holds doubles, whatever their number") {
    const Scratch scratch;
    for (const std::size_t columns : {1u, 2u, 7u, 5000u}) {
        const auto lattice = test::lattice(columns, 3);

        write_vti(scratch / "a.vti", lattice, test::experiment(), Precision::double_);

        auto document = parse_document(test::get(scratch / "a.vti"));
        CHECK(document.arrays["V"].type == "Float64");
        CHECK(numbers<double>(document.arrays["V"]) == lattice.conc[1]);
    }
}

TEST_CASE("free cells as .vtp: points, vertices and all arrays") {
    const Scratch scratch;
    auto cells = test::cells({1, 2.5}, {-1, 3});
    cells.polarity_x = {0.6, 0};
    cells.polarity_y = {0.8, 0};
    cells.birth = {0, 4294967295u};
    cells.fixed = {1, 0};

    write_vtp(scratch / "a.vtp", cells, test::experiment(), Precision::single_);
    auto document = parse_document(test::get(scratch / "a.vtp"));

    CHECK(document.problem.empty());
    CHECK(document.elements["VTKFile"]["type"] == "PolyData");
    CHECK(document.elements["Piece"]["NumberOfPoints"] == "2");
    CHECK(document.elements["Piece"]["NumberOfVerts"] == "2");
    CHECK(document.arrays.size() == 12);
    CHECK(document.arrays["centre"].components == "3");
    CHECK(numbers<float>(document.arrays["centre"]) == std::vector<float>{1, -1, 0, 2.5, 3, 0});
    CHECK(numbers<std::int64_t>(document.arrays["connectivity"]) == std::vector<std::int64_t>{0, 1});
    CHECK(numbers<std::int64_t>(document.arrays["offsets"]) == std::vector<std::int64_t>{1, 2});
    CHECK(numbers<std::int64_t>(document.arrays["id"]) == std::vector<std::int64_t>{0, 1});
    CHECK(numbers<std::int64_t>(document.arrays["birth"]) == std::vector<std::int64_t>{0, 4294967295});
    CHECK(numbers<std::int32_t>(document.arrays["neighbours"]) == cells.neighbours);
    CHECK(numbers<std::uint8_t>(document.arrays["fixed"]) == cells.fixed);
    CHECK(numbers<float>(document.arrays["polarity"]) == std::vector<float>{0.6f, 0.8f, 0, 0, 0, 0});
    CHECK(numbers<float>(document.arrays["conc U"]) == std::vector<float>{0.5, 1.5});
    CHECK(numbers<float>(document.arrays["diff V"]) == std::vector<float>{0.03125, 0.03125});
}

TEST_CASE("VTK files that cannot be are refused, names are escaped") {
    const Scratch scratch;
    auto experiment = test::experiment();
    experiment.chemicals[0].name = "a<\"b\"&c>";

    write_vti(scratch / "a.vti", test::lattice(2, 2), experiment, Precision::single_);
    auto document = parse_document(test::get(scratch / "a.vti"));

    CHECK(document.problem.empty());
    CHECK(document.arrays.count("a&lt;&quot;b&quot;&amp;c&gt;") == 1);
    CHECK_THAT(
        test::error_of([&] { write_vti(scratch / "b.vti", test::cells({0}, {0}), experiment, Precision::single_); }),
        Contains("free cells are no image"));
    CHECK_THAT(test::error_of([&] { write_vtp("/dev/full", test::cells({0}, {0}), experiment, Precision::single_); }),
               Contains("No space left"));
    CHECK(scratch.names() == std::vector<std::string>{"a.vti"});
}
