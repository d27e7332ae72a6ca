// The files of a run.
#include "io/results.hpp"
#include "core/error.hpp"
#include "io/exr.hpp"
#include "io/field.hpp"
#include "io/npy.hpp"
#include "scratch.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

using Catch::Matchers::Contains;
using namespace pelage;
using test::Scratch;
using Names = std::vector<std::string>;

namespace {

ResultOptions everything() {
    ResultOptions options;
    options.formats = parse_formats("exr,png,npy,csv,vti");
    options.attributes = {{"seed", "7"}};
    return options;
}

Names sorted(Names names) {
    std::sort(names.begin(), names.end());
    return names;
}

}  // namespace

TEST_CASE("a lattice's results") {
    const Scratch scratch;
    auto experiment = test::experiment();
    experiment.outputs = {{1, {"gray", {}}, {}}, {0, {"inferno", {}}, {}}, {0, {"viridis", {}}, {}}};
    const auto lattice = test::lattice(5, 3);

    const auto files = write_results(scratch / "a/b", "final", lattice, experiment, everything());

    CHECK(files == Names{"final.exr", "final.png", "final.U.png", "final.U-2.png", "final.U.npy", "final.V.npy",
                         "final.csv", "final.vti"});
    Names there;
    for (const auto& entry : std::filesystem::directory_iterator(scratch / "a/b"))
        there.push_back(entry.path().filename());
    CHECK(sorted(there) == sorted(files));
    const auto picture = read_exr(scratch / "a/b/final.exr");
    CHECK(picture.names == Names{"U", "V"});
    CHECK(picture.values == lattice.conc);
    CHECK(picture.attributes == Attributes{{"iteration", "42"}, {"seed", "7"}});
    const auto array = read_npy(scratch / "a/b/final.V.npy");
    CHECK(array.shape == std::vector<std::size_t>{3, 5});
    CHECK(array.values == lattice.conc[1]);
    const auto png = read_field(scratch / "a/b/final.png", "");
    CHECK(png->columns == 80);
    CHECK(png->values.front() == 1.0);  // row 0 at the bottom: V falls with the cell
    CHECK(png->values.back() == 0.0);
}

TEST_CASE("free cells' results") {
    const Scratch scratch;
    auto experiment = test::experiment();
    experiment.texture = {32, 16};
    const auto cells = test::cells({0, 2, 4}, {0, 0, 0});

    const auto files = write_results(scratch.folder(), "final", cells, experiment, everything());
    const auto snapshot = write_results(scratch.folder(), "0100", cells, experiment, {{Format::png}, {}, {}, {}});

    CHECK(files ==
          Names{"final.png", "final.U.npy", "final.V.npy", "final.csv", "final.vtp", "texture.exr", "texture.png"});
    CHECK(snapshot == Names{"0100.png", "0100.texture.png"});
    CHECK(scratch.names() == sorted({"0100.png", "0100.texture.png", "final.U.npy", "final.V.npy", "final.csv",
                                     "final.png", "final.vtp", "texture.exr", "texture.png"}));
    CHECK(read_npy(scratch / "final.U.npy").shape == std::vector<std::size_t>{3});
    const auto texture = read_exr(scratch / "texture.exr");
    CHECK(texture.columns == 32);
    CHECK(texture.rows == 16);
    CHECK(texture.names == Names{"U", "V"});
    CHECK(texture.values[0].front() < texture.values[0].back());
    CHECK(read_field(scratch / "texture.png", "")->columns == 32);
}

TEST_CASE("precision decides on the type of numbers, names of chemicals make safe names of files") {
    const Scratch scratch;
    auto experiment = test::experiment();
    experiment.chemicals[0].name = "../a b";
    experiment.chemicals[1].name = "../a/b";
    auto options = everything();
    options.formats = {Format::npy};
    options.precision = Precision::double_;

    const auto files = write_results(scratch.folder(), "final", test::lattice(2, 1), experiment, options);

    CHECK(files == Names{"final.___a_b.npy", "final.___a_b-2.npy"});
    CHECK(scratch.names() == sorted(files));
    CHECK_THAT(test::get(scratch / files[0]), Contains("'<f8'"));
}

TEST_CASE("formats are a list with commas") {
    CHECK(parse_formats("png") == std::vector{Format::png});
    CHECK(parse_formats("csv,vtp,vti,exr") == std::vector{Format::csv, Format::vtk, Format::exr});
    CHECK_THAT(test::error_of([] { parse_formats("png,gif"); }), Contains("'gif'") && Contains("exr, png, npy, csv"));
    CHECK_THAT(test::error_of([] { parse_formats(""); }), Contains("''"));
    CHECK_THAT(test::error_of([] { parse_formats("png,"); }), Contains("''"));
}

TEST_CASE("names of snapshots sort as the run goes") {
    CHECK(snapshot_stem(0, 10000) == "00000");
    CHECK(snapshot_stem(250, 10000) == "00250");
    CHECK(snapshot_stem(10000, 10000) == "10000");
    CHECK(snapshot_stem(12, 7) == "12");
}

TEST_CASE("results that cannot be are refused in words") {
    const Scratch scratch;
    test::put(scratch / "file", "");
    auto experiment = test::experiment();
    const auto problem = [&](const std::filesystem::path& folder, const Snapshot& snapshot) {
        return test::error_of([&] { write_results(folder, "final", snapshot, experiment, everything()); });
    };
    auto crooked = test::lattice(3, 2);
    crooked.rows = 3;

    CHECK_THAT(problem(scratch / "file/out", test::lattice(2, 2)),
               Contains("cannot make the folder") && Contains("file/out"));
    CHECK_THAT(problem(scratch.folder(), crooked), Contains("6 cells") && Contains("9"));
    experiment.outputs[0].chemical = 9;
    CHECK_THAT(problem(scratch.folder(), test::lattice(2, 2)), Contains("chemical 9"));
    CHECK(scratch.names() == Names{"file"});
}
