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
    CHECK(picture.names == Names{"U", "V", "Y"});
    CHECK(picture.values == std::vector{lattice.conc[0], lattice.conc[1], lattice.conc[1]});  // V is drawn first
    CHECK(picture.attributes ==
          Attributes{{"iteration", "42"}, {"time", "42"}, {"pelage:chemicals", "U V"}, {"seed", "7"}});
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
    ResultOptions pictures;
    pictures.formats = {Format::png};
    const auto snapshot = write_results(scratch.folder(), "0100", cells, experiment, pictures);

    CHECK(files ==
          Names{"final.png", "final.U.npy", "final.V.npy", "final.csv", "final.vtp", "texture.exr", "texture.png"});
    CHECK(snapshot == Names{"0100.png", "0100.texture.png"});
    CHECK(scratch.names() == sorted({"0100.png", "0100.texture.png", "final.U.npy", "final.V.npy", "final.csv",
                                     "final.png", "final.vtp", "texture.exr", "texture.png"}));
    CHECK(read_npy(scratch / "final.U.npy").shape == std::vector<std::size_t>{3});
    const auto texture = read_exr(scratch / "texture.exr");
    CHECK(texture.columns == 32);
    CHECK(texture.rows == 16);
    CHECK(texture.names == Names{"U", "V", "Y"});
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

TEST_CASE("maps of a chemical stand beside the pictures, of the lattice and of its texture") {
    const Scratch scratch;
    auto experiment = test::experiment();
    experiment.outputs = {
        {1, {}, {}, false, Drawing::normal, 3.0}, {0, {"gray", {}}, {}}, {1, {}, {}, false, Drawing::height}};
    experiment.texture = {8, 4};
    auto options = everything();
    options.formats = {Format::png};

    const auto files = write_results(scratch.folder(), "final", test::lattice(5, 3), experiment, options);

    CHECK(files == Names{"final.png", "final.V.normal.png", "final.V.height.png", "texture.V.normal.png", "texture.png",
                         "texture.V.height.png"});
    CHECK(scratch.names() == sorted(files));
    CHECK(read_field(scratch / "final.V.height.png", "")->columns == 5);  // maps are not enlarged
    CHECK(read_field(scratch / "texture.V.normal.png", "")->columns == 8);
    CHECK(test::get(scratch / "final.V.height.png")[24] == 16);
    CHECK(test::get(scratch / "final.V.normal.png")[24] == 8);
    options.deep_png = true;
    write_results(scratch.folder(), "final", test::lattice(5, 3), experiment, options);
    for (const auto& file : files) CHECK(test::get(scratch / file)[24] == 16);
}

TEST_CASE("a chemical named Y is what other programs show already") {
    const Scratch scratch;
    auto experiment = test::experiment();
    experiment.chemicals[1].name = "Y";
    auto options = everything();
    options.formats = {Format::exr};
    options.exr_type = ExrType::half;

    write_results(scratch.folder(), "final", test::lattice(5, 3), experiment, options);

    CHECK(read_exr(scratch / "final.exr").names == Names{"U", "Y"});
}

TEST_CASE("pictures draw in the range they are given, unless the output has its own") {
    const Scratch scratch;
    auto experiment = test::experiment();
    experiment.outputs = {{0, {"gray", {}}, {}}, {0, {"gray", {}}, std::array{0.0, 100.0}}};
    ResultOptions options;
    options.formats = {Format::png};
    options.ranges = {ValueRange{-10, 20}, ValueRange{-10, 20}};

    write_results(scratch.folder(), "final", test::lattice(2, 1), experiment, options);

    CHECK(read_field(scratch / "final.png", "")->values[0] == Approx(10.5 / 30).margin(0.003));
    CHECK(read_field(scratch / "final.U.png", "")->values[0] == Approx(0.005).margin(0.003));
}

TEST_CASE("pictures that are given no range can be left out, and the others keep their names") {
    const Scratch scratch;
    auto experiment = test::experiment();
    experiment.texture = {8, 4};
    experiment.outputs = {
        {0, {}, std::array{0.0, 1.0}}, {1, {}, std::array{0.0, 1.0}}, {1, {}, {}}, {1, {}, {}, false, Drawing::normal}};
    ResultOptions options;
    options.formats = {Format::png};
    options.ranges = {{}, {}, ValueRange{-10, 20}, {}};
    options.ranged_only = true;

    CHECK(write_results(scratch.folder(), "7", test::lattice(2, 1), experiment, options) == Names{"7.V-2.png"});
    CHECK(scratch.names() == Names{"7.V-2.png"});
    options.ranges[0] = ValueRange{0, 1};
    CHECK(write_results(scratch.folder(), "7", test::lattice(2, 1), experiment, options) ==
          Names{"7.png", "7.V-2.png", "7.texture.png"});
}

TEST_CASE("names are told before anything is written, and each file as it is begun") {
    const Scratch scratch;
    Names before;
    Names begun;
    auto options = everything();
    options.before = [&](const Names& names) {
        before = names;
        CHECK(scratch.names().empty());
    };
    options.begins = [&](const std::string& name) { begun.push_back(name); };

    const auto files = write_results(scratch.folder(), "final", test::lattice(300, 300), test::experiment(), options);

    CHECK(before == files);
    CHECK(sorted(begun) == sorted(files));
    CHECK(scratch.names() == sorted(files));
}

TEST_CASE("formats are a list with commas") {
    CHECK(parse_formats("png") == std::vector{Format::png});
    CHECK(parse_formats("csv,vtp,vti,exr") == std::vector{Format::csv, Format::vtk, Format::exr});
    CHECK_THAT(test::error_of([] { parse_formats("png,gif"); }), Contains("'gif'") && Contains("exr, png, npy, csv"));
    CHECK_THAT(test::error_of([] { parse_formats(""); }), Contains("''"));
    CHECK_THAT(test::error_of([] { parse_formats("png,"); }), Contains("''"));
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
