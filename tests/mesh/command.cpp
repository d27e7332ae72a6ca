// A run on a mesh as a user starts it: its files, its films, its checkpoints.
#include "mesh/read_ply.hpp"
#include "mesh/shapes.hpp"
#include "support/process.hpp"

#include <catch2/catch.hpp>

using namespace test;

namespace {

const std::string spots =
    "define chemical U\ndefine chemical V\nuse chemical U conc 4 dev 1 diff 0.1\nuse chemical V conc 4 dev 1 diff "
    "0.02\n"
    "create icosphere 3 weights cotangent\nrule always react U V scale 0.01 turing alpha 16 beta 12\n"
    "rule probability 0.1 change V conc 0 dev 0.01\nsnap at 10\nstop at 40\noutput V from 0 0 1\noutput U\n";

std::vector<std::string> running(const Folder& folder, const std::string& out, std::vector<std::string> more) {
    std::vector<std::string> words{"run", (folder / "a.pex").string(), "--quiet", "--out", (folder / out).string()};
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

}  // namespace

TEST_CASE("a run on a mesh leaves a view and a coloured mesh, and other formats on demand") {
    const Folder folder;
    folder.write("a.pex", spots);
    const Outcome usual = command(running(folder, "a", {}));
    INFO(usual.err);
    REQUIRE(usual.exit_code == 0);
    for (const char* name : {"10.png", "10.ply", "final.png", "final.U.png", "final.ply", "manifest.json"})
        CHECK(std::filesystem::exists(folder / "a" / name));
    const pelage::Mesh mesh = pelage::parse_ply(read_all(folder / "a" / "final.ply"), "final.ply");
    CHECK(mesh.triangles == pelage::icosphere(3).triangles);

    REQUIRE(command(running(folder, "b", {"--format", "csv,npy,vtp"})).exit_code == 0);
    CHECK(read_all(folder / "b" / "final.csv").starts_with("id,x,y,z,birth,neighbours"));
    CHECK(std::filesystem::exists(folder / "b" / "final.V.npy"));
    CHECK(read_all(folder / "b" / "final.vtp").find("NumberOfPolys=\"1280\"") != std::string::npos);

    const Outcome refused = command(running(folder, "c", {"--format", "exr"}));
    CHECK(refused.exit_code == 2);
    CHECK_THAT(refused.err, Catch::Contains("a mesh makes no EXR picture"));
}

TEST_CASE("a run on a mesh that is resumed ends in the bits of one that was not, on either backend") {
    const Folder folder;
    folder.write("a.pex", spots);
    const std::vector<std::string> npy{"--format", "npy"};
    REQUIRE(command(running(folder, "whole", npy)).exit_code == 0);
    REQUIRE(command(running(folder, "half", {"--iterations", "25", "--checkpoint-every", "20"})).exit_code == 0);
    for (const char* backend : {"opencl", "reference"}) {
        INFO(backend);
        const Outcome rest = command(running(
            folder, backend,
            {"--resume", (folder / "half" / "checkpoint.pelage").string(), "--format", "npy", "--backend", backend}));
        INFO(rest.err);
        REQUIRE(rest.exit_code == 0);
        CHECK(read_all(folder / backend / "final.V.npy") == read_all(folder / "whole" / "final.V.npy"));
    }
}

TEST_CASE("a .ply file of what is no mesh is refused") {
    const Folder folder;
    folder.write("a.pex", "define chemical U\ncreate matrix 4 4\nstop at 1\n");
    const Outcome refused = command(running(folder, "a", {"--format", "ply"}));
    CHECK(refused.exit_code == 2);
    CHECK_THAT(refused.err, Catch::Contains("only a mesh makes a .ply file"));
}
