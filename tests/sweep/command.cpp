// `pelage sweep` as a user meets it.
#include "core/prepattern.hpp"
#include "csv.hpp"
#include "io/field.hpp"
#include "io/npy.hpp"
#include "language/parse.hpp"
#include "reference/backend.hpp"
#include "support/process.hpp"
#include "sweep/sheet.hpp"
#include "sweep/tile.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

using namespace pelage;
using Catch::Contains;
using test::command;
using test::Folder;
using test::Outcome;
using test::read_all;
using test::Row;
using test::rows_of;
using test::without_times;

namespace {

const std::string text =
    "define parameter F 0.037 from 0 to 0.1\ndefine parameter K 0.06\ndefine parameter side 24\n"
    "define chemical U limit 1\ndefine chemical V limit 1\nuse seed 7\n"
    "use chemical U conc 1 diff 0.2\nuse chemical V conc 0 dev 0.4 diff 0.1\ncreate matrix side 20 wrap\n"
    "rule always react U V gray-scott f F k K\nstop at 200\noutput V colormap viridis\n";

class Bench {
public:
    Outcome sweep(std::vector<std::string> more, const std::string& out = "out") const {
        std::vector<std::string> words{"sweep", file, "--backend", "reference", "--out", (folder / out).string()};
        words.insert(words.end(), more.begin(), more.end());
        return command(words);
    }
    std::string csv(const std::string& out = "out") const { return read_all(folder / (out + "/sweep.csv")); }

    Folder folder;
    std::string file = folder.write("map.pex", text);
};

}  // namespace

TEST_CASE("each tile ends in the bits of its single run, on both backends, structure and seeds included") {
    const Bench bench;
    const bool device = GENERATE(false, true);
    std::vector<std::string> words{"--vary", "K=0.05,0.065", "--vary", "side=16:32:2", "--replicates", "2"};
    if (device) words.insert(words.end(), {"--backend", "opencl", "--no-self-test"});
    std::vector<std::string> all{"sweep", bench.file, "--out", (bench.folder / "out").string()};
    if (!device) all.insert(all.end(), {"--backend", "reference"});
    all.insert(all.end(), words.begin(), words.end());
    const Outcome outcome = command(all);
    INFO(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    const std::vector<Row> rows = rows_of(bench.csv());
    REQUIRE(rows.size() == 8);
    for (const Row& row : rows) {
        Experiment experiment = parse_experiment(text, "map.pex", "", nullptr, StartPictures::read,
                                                 {{"K", row.at("K")}, {"side", row.at("side")}});
        experiment.seed = std::stoll(row.at("seed"));
        CHECK(*experiment.seed == 7 + std::stoll(row.at("replicate")));
        const auto tissue = reference_backend(Precision::single_)->make_tissue(experiment, initial_state(experiment));
        tissue->advance(200);
        CHECK(row.at("hash") == sweep::hash_of(tissue->read()));
    }
    CHECK(std::filesystem::file_size(bench.folder / "out/sheet.png") > 1000);
}

TEST_CASE(
    "of an rgb output the sheet shows the pictures as they are, without a bar, and the table names what it measures") {
    const Folder folder;
    const auto swept = [&](const std::string& output) {
        const std::string file =
            folder.write("a.pex",
                         "define parameter p 0 from 0 to 1\ndefine chemical U\ndefine chemical V\n"
                         "use chemical U conc (ROW / 19)\nuse chemical V conc p\ncreate matrix 20 20\nstop at 20\n" +
                             output + "\n");
        std::filesystem::remove_all(folder / "out");
        const Outcome outcome = command(
            {"sweep", file, "--backend", "reference", "--vary", "p=0.25,0.75", "--quiet", "--out", folder / "out"});
        INFO(outcome.err);
        REQUIRE(outcome.exit_code == 0);
        return rows_of(read_all(folder / "out/sweep.csv"));
    };
    // The darkest luminance right of the tiles, where the bar would be.
    const auto margin = [&] {
        const auto sheet = read_field(folder / "out/sheet.png", "");
        double darkest = 1.0;
        for (std::size_t row = 100; row < 160; ++row) {
            for (std::size_t column = 300; column < 310; ++column)
                darkest = std::min(darkest, sheet->values[row * sheet->columns + column]);
        }
        return darkest;
    };

    CHECK(swept("output V").at(1).at("of") == "V");
    const std::vector<Row> rows = swept("output rgb (U) (V) (0.5)");
    CHECK(rows.at(0).at("of") == "red");
    CHECK(rows.at(0).at("maximum") == "1");
    CHECK(margin() == 1.0);
    const NpyArray tile = read_npy(folder / "out/tiles/.1.npy");
    CHECK(tile.shape == std::vector<std::size_t>{3, 20, 20});
    CHECK(tile.values.at(400) == 0.75);
    CHECK(swept("output (2 * U)").at(0).at("of") == "formula");
    CHECK(margin() < 0.9);

    const sweep::TilePicture picture{2, 1, {0, 1, 0.5, 0.5, 1, 0}};
    Output output;
    output.expressions.resize(3);
    const sweep::Mosaic made = sweep::mosaic({picture, {}}, {2, 1, true}, output, 1);
    CHECK(made.picture.at(0, 0) == Rgb{0, 128, 255});
    CHECK(made.picture.at(1, 0) == Rgb{255, 128, 0});

    const std::size_t second = made.tile_columns + sweep::gap;  // has no picture
    CHECK(made.picture.at(second, 0) != Rgb{255, 255, 255});
    CHECK(made.picture.at(made.tile_columns, 0) == Rgb{255, 255, 255});
}

TEST_CASE(
    "a sweep that is cut off goes on where it was, and ends in the same table, another one is refused its folder") {
    const Bench bench;
    const std::vector<std::string> words{"--vary", "K=0.05:0.07:5", "--vary", "F=0.02,0.04"};
    REQUIRE(bench.sweep(words, "whole").exit_code == 0);
    REQUIRE(bench.sweep(words).exit_code == 0);
    const std::string whole = bench.csv();
    // As after a kill: some rows, the last one half.
    std::size_t cut = 0;
    for (int line = 0; line < 4; ++line) cut = whole.find('\n', cut) + 1;
    std::ofstream(bench.folder / "out/sweep.csv", std::ios::binary) << whole.substr(0, cut + 9);
    const Outcome again = bench.sweep(words);
    INFO(again.err);
    CHECK(again.exit_code == 0);
    CHECK_THAT(again.err, Contains("3 of 10 tiles are there already"));
    CHECK_THAT(again.out, Contains("7 tiles in"));
    CHECK(without_times(bench.csv()) == without_times(bench.csv("whole")));
    CHECK_THAT(bench.sweep(words).err, Contains("10 of 10 tiles are there already"));

    std::filesystem::remove(bench.folder / "out/tiles/.4.npy");
    CHECK_THAT(bench.sweep(words).out, Contains("1 tile in"));
    std::ofstream(bench.folder / "out/tiles/.5.npy", std::ios::binary) << "damaged";
    const Outcome mended = bench.sweep(words);
    CHECK_THAT(mended.err, Contains("9 of 10 tiles are there already"));
    CHECK_THAT(mended.out, Contains("1 tile in"));
    CHECK(without_times(bench.csv()) == without_times(bench.csv("whole")));

    const Outcome other = bench.sweep({"--vary", "K=0.05:0.07:6", "--vary", "F=0.02,0.04"});
    CHECK(other.exit_code == 2);
    CHECK_THAT(other.err, Contains("holds another sweep"));
    std::ofstream(bench.file, std::ios::app) << "output U\n";
    CHECK(bench.sweep(words).exit_code == 2);
    CHECK(without_times(bench.csv()) == without_times(bench.csv("whole")));
}

TEST_CASE("a sweep whose start state changed since is another sweep") {
    const Folder folder;
    const std::string file = folder.write(
        "start.pex",
        "define parameter d 0.1\ndefine chemical U conc \"start.npy\"\nuse chemical U diff d\ncreate matrix 4 4\nstop "
        "at 90\noutput U\n");
    const auto sweep = [&](float first) {
        std::vector<double> values(16, 1.0);
        values.front() = first;
        write_npy(folder / "start.npy", {4, 4}, values, NpyType::float32);
        return command({"sweep", file, "--backend", "reference", "--vary", "d=0.1,0.2", "--out", folder / "out"});
    };
    REQUIRE(sweep(0.5f).exit_code == 0);
    CHECK(sweep(0.5f).exit_code == 0);
    const Outcome changed = sweep(0.25f);
    CHECK(changed.exit_code == 2);
    CHECK_THAT(changed.err, Contains("its experiment, options or input files changed"));
}

TEST_CASE("a tile whose picture has no numbers is NaN, and one too short to judge is undecided") {
    const Folder folder;
    const auto verdict = [&](const std::string& output, const std::string& last) {
        const std::string file =
            folder.write("short.pex",
                         "define parameter d 0.1\ndefine chemical U\ndefine chemical V\nuse chemical U conc 1 dev 0.5 "
                         "diff d\ncreate matrix 8 8 wrap\nstop at " +
                             last + "\noutput " + output + "\n");
        std::filesystem::remove_all(folder / "out");
        const Outcome outcome =
            command({"sweep", file, "--backend", "reference", "--vary", "d=0.1,0.2", "--out", folder / "out"});
        INFO(outcome.err);
        REQUIRE(outcome.exit_code == 0);
        return rows_of(read_all(folder / "out/sweep.csv")).at(1).at("verdict");
    };
    CHECK(verdict("(U / (V - V))", "100") == "NaN");
    CHECK(verdict("U", "1") == "undecided");
    CHECK(verdict("U", "0") == "undecided");
    CHECK(verdict("U", "4000") == "uniform");
}

TEST_CASE("every device takes tiles, and the table is the reference's") {
    const Bench bench;
    const std::vector<std::string> words{"--vary", "K=0.05:0.07:5"};
    REQUIRE(bench.sweep(words, "reference").exit_code == 0);
    const Outcome outcome = command({"sweep", bench.file, "--device", "all", "--no-self-test", "--vary",
                                     "K=0.05:0.07:5", "--out", (bench.folder / "all").string()});
    INFO(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    CHECK_THAT(outcome.err, Contains("backend: opencl"));
    CHECK(without_times(bench.csv("all")) == without_times(bench.csv("reference")));
}

TEST_CASE("what tiles end in: uniform, a pattern, NaN, an unstable step, and settled tiles may end early") {
    const Folder folder;
    const std::string file =
        folder.write("kinds.pex",
                     "define parameter g 0\ndefine parameter d 0.1\ndefine chemical U floor none\nuse chemical U conc "
                     "1 dev 0.5 diff d\n"
                     "create matrix 16 16 wrap\nrule always react U by (g * U * U * U)\nstop at 400\noutput U\n");
    const auto verdicts = [&](const std::string& vary, const std::string& out) {
        const Outcome outcome =
            command({"sweep", file, "--backend", "reference", "--vary", vary, "--out", (folder / out).string()});
        INFO(outcome.err);
        REQUIRE(outcome.exit_code == 0);
        std::vector<std::string> all;
        for (const Row& row : rows_of(read_all(folder / (out + "/sweep.csv")))) all.push_back(row.at("verdict"));
        return all;
    };
    CHECK(verdicts("g=0,10", "a") == std::vector<std::string>{"uniform", "NaN"});
    CHECK(verdicts("g=10,20", "none") == std::vector<std::string>{"NaN", "NaN"});
    CHECK(std::filesystem::exists(folder / "none/sheet.png"));
    CHECK(verdicts("d=0,1", "b") == std::vector<std::string>{"stationary", "unstable"});

    const Outcome early = command({"sweep", file, "--backend", "reference", "--vary", "d=0,0.3", "--until", "steady",
                                   "1e-3", "--out", (folder / "c").string()});
    REQUIRE(early.exit_code == 0);
    const std::vector<Row> rows = rows_of(read_all(folder / "c/sweep.csv"));
    CHECK(rows.at(0).at("iterations") == "4");
    CHECK(std::stoi(rows.at(1).at("iterations")) < 400);
}

TEST_CASE("a sweep that makes no sense says why") {
    const Bench bench;
    const auto refused = [&](const std::vector<std::string>& words) {
        const Outcome outcome = bench.sweep(words);
        CHECK(outcome.exit_code == 2);
        return outcome.err;
    };
    CHECK_THAT(refused({}), Contains("nothing varies"));
    CHECK_THAT(refused({"--vary", "Q=1,2"}), Contains("defines no parameter of that name; defined there: F, K, side"));
    CHECK_THAT(refused({"--vary", "F=0.05,0.2"}),
               Contains("0.2 is out of range; parameter 'F' must be a number from 0 to 0.1"));
    CHECK_THAT(refused({"--vary", "F=0.2"}), Contains("pelage: --vary F=0.2: parameter 'F' must be a number"));
    const std::string table = bench.folder.write("points.csv", "Q\n1\n");
    CHECK_THAT(refused({"--points", table}), Contains("pelage: --points " + table + ": Q=1: "));
    CHECK_THAT(refused({"--vary", "K=0.05,0.06", "--seed", "0"}), Contains("--seed 0 takes one from the clock"));
    CHECK_THAT(refused({"--vary", "F=1:2"}), Contains("a range is written"));
    CHECK_THAT(refused({"--vary", "F=0:0.1:3", "--samples", "5"}), Contains("where samples are drawn"));
    CHECK_THAT(refused({"--samples", "5"}), Contains("give at least one"));
    CHECK_THAT(refused({"--vary", "F=0:0.1:3", "--latin"}), Contains("--samples"));
    CHECK_THAT(refused({"--vary", "K=1,2", "--points", bench.file}), Contains("leave --vary out"));
    CHECK_THAT(refused({"--points", table, "--latin"}), Contains("none is drawn"));
    CHECK_THAT(refused({"--vary", "K=0.05,0.06", "--set", "K=0.07"}), Contains("--set K=0.07: --vary gives 'K' its"));
    CHECK_THAT(refused({"--vary", "side=8:9:3"}), Contains("--vary side: 8.5 is not a whole number"));
    const std::string sides = bench.folder.write("sides.csv", "side\n8\n8.5\n");
    CHECK_THAT(refused({"--points", sides}), Contains(": side (point 2): 8.5 is not a whole number"));
    // What is wrong with a later tile is said before the first one runs.
    CHECK_THAT(refused({"--vary", "side=8,9,0"}),
               Contains("tile 2 (side=0): ") && Contains("is 0, which is out of range"));
    CHECK_THAT(refused({"--vary", "side=8,30000000"}), Contains("30000000") || Contains("may be used"));
    CHECK_THAT(refused({"--vary", "K=1,2", "--format", "xyz"}), Contains("unknown format 'xyz'"));
    CHECK_THAT(refused({"--vary", "K=1,2", "--format", "ply"}), Contains("only a mesh makes a .ply file"));
    CHECK_THAT(refused({"--vary", "K=1,2", "--until", "steady", "0"}), Contains("steady TOLERANCE"));
    CHECK_THAT(refused({"--vary", "K=1,2", "--until", "calm", "0.1"}), Contains("steady TOLERANCE"));
    CHECK_THAT(refused({"--vary", "K=0:1:1001", "--vary", "F=0:0.1:1001"}), Contains("more than 1000000 tiles"));
    CHECK_THAT(command({"sweep", bench.file, "--vary", "K=0.05,0.06", "--out", "/proc/nothing"}).err,
               Contains("/proc/nothing"));
    CHECK_FALSE(std::filesystem::exists(bench.folder / "out/sweep.csv"));
    const std::string cells =
        bench.folder.write("cells.pex", "define parameter d 1\ndefine chemical U\ncreate cell 0 d\n");
    CHECK_THAT(command({"sweep", cells, "--vary", "d=1,2", "--out", (bench.folder / "cells").string()}).err,
               Contains("free cells have no rows and columns"));
}
