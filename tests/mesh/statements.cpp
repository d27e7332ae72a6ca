// The statements that create meshes, and what a mesh refuses.
#include "core/error.hpp"
#include "core/surface.hpp"
#include "io/mesh_results.hpp"
#include "language/parse.hpp"
#include "support/process.hpp"

#include <catch2/catch.hpp>

#include <string>
#include <utility>
#include <vector>

using namespace pelage;

namespace {

const std::string square = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 1\nf 1 2 3 4\n";

std::string text_refusal(const std::string& text, const std::filesystem::path& folder = ".") {
    try {
        parse_experiment(text, "a.pex", folder);
        return "";
    } catch (const Error& error) {
        return error.what();
    }
}

}  // namespace

TEST_CASE("a mesh is read from a file beside the experiment, scaled, and named among its inputs") {
    const test::Folder folder;
    folder.write("a.obj", square);
    const Experiment experiment = parse_experiment(
        "define chemical U\ncreate mesh \"a.obj\" scale 0.5 weights cotangent\n", "a.pex", folder.path());

    const MeshSurface& surface = *surface_of(experiment);
    CHECK(surface.mesh.vertices.at(2) == Point{1, 1, 0});
    CHECK(surface.mesh.triangles.size() == 2);
    CHECK(surface.weights == MeshWeights::cotangent);
    REQUIRE(experiment.inputs.size() == 1);
    CHECK(experiment.inputs[0].throughout);
    CHECK(experiment.inputs[0].sha256.size() == 64);
}

TEST_CASE("the sizes of meshes made by rule may be parameters") {
    const Experiment experiment = parse_experiment(
        "define parameter n 2\ndefine parameter s 3\ndefine chemical U\ncreate icosphere n scale s\n", "a.pex", ".");

    CHECK(surface_of(experiment)->cells() == 162);
    CHECK(length(surface_of(experiment)->mesh.vertices[5]) == Approx(3 * std::sqrt(162 / (4 * 3.14159265358979))));
}

TEST_CASE("a mesh that cannot be is refused with its place in the experiment") {
    const test::Folder folder;
    folder.write("bad.obj", "v 0 0 x\n");
    folder.write("flat.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n");
    folder.write("none.obj", "v 0 0 0\nv 0 0 0\nv 0 0 0\nf 1 2 3\n");
    folder.write("a.stl", "solid\n");
    const std::vector<std::pair<std::string, std::string>> wrong{
        {"create mesh", "a.pex:2:12: the line ends too early"},
        {"create mesh \"gone.obj\"", "a.pex:2:13: "},
        {"create mesh \"bad.obj\"", "'x' in a vertex; allowed are numbers"},
        {"create mesh \"none.obj\"", "no triangle with three corners in three places is left"},
        {"create mesh \"flat.obj\" weights cotangent", "has no area"},
        {"create mesh \"a.stl\"", "is no .obj and no .ply file"},
        {"create icosphere 10", "a.pex:2:18: "},
        {"create icosphere", "a.pex:2:17: the line ends too early"},
        {"create torus 20 20", "more around than across"},
        {"create torus 4000000 30", "at most 4000000 vertices"},
        {"create icosphere 1 weights", "a.pex:2:27: the line ends too early"},
        {"create icosphere 1 weights equal", "uniform"},
        {"create icosphere 1 scale 0", "a.pex:2:26: "},
        {"create icosphere 1 scale 1e30", "takes a vertex to"},
        {"create icosphere 1 at 0 0", "weights"},
        {"create icosphere 1\ncreate icosphere 1", "a mesh"},
        {"create icosphere 1\ncreate cell 0 0", "a mesh"},
        {"create cell 0 0\ncreate icosphere 1", "a mesh"},
    };
    for (const auto& [line, part] : wrong) {
        INFO(line);
        CHECK_THAT(text_refusal("define chemical U\n" + line + "\n", folder.path()), Catch::Contains(part));
    }
}

TEST_CASE("what belongs to a plane is refused on a mesh in one sentence") {
    const std::vector<std::string> lines{
        "rule always expand rows 1",
        "rule always polarize U conc",
        "rule always divide",
        "rule always move 1",
        "rule if ROW > 1 change U conc 1",
        "rule always react U by (gradient_x(U))",
        "rule if LAYER > 1 change U conc 1",
        "define stencil five-point",
        "texture size 10 10",
        "output U height",
        "output U normal 1",
        "output U slice z 1",
        "use polarity 30",
    };
    for (const std::string& line : lines) {
        INFO(line);
        const std::string found = text_refusal("define chemical U\n" + line + "\ncreate icosphere 1\n");
        CHECK_THAT(found, Catch::StartsWith("a.pex:2:"));
        CHECK(found.find('\n') == std::string::npos);
    }
    CHECK_THAT(text_refusal("define chemical U anisotropic\ncreate icosphere 1\n"), Catch::StartsWith("a.pex:1:"));
    CHECK(text_refusal("define chemical U\ncreate icosphere 1\noutput U from 1 0 0\n").empty());
    CHECK_THAT(text_refusal("define chemical U\ncreate matrix 2 2\noutput U from 1 0 0\n"), Catch::Contains("a mesh"));
    CHECK_THAT(text_refusal("define chemical U\ncreate icosphere 1\noutput U from 0 0 0\n"),
               Catch::Contains("direction"));
    CHECK_THAT(text_refusal("define chemical U\ncreate matrix 2 2\nrule if Z > 1 change U conc 1\n"),
               Catch::Contains("a volume or a mesh"));
}
