// `pelage sweep --batch`: tiles of one structure run together, and the table does not show it.
#include "csv.hpp"
#include "support/process.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <string>
#include <vector>

using Catch::Contains;
using test::Child;
using test::command;
using test::Folder;
using test::Outcome;
using test::read_all;
using test::without_times;

namespace {

// Structures differ by side; rules draw, a phase changes a rate, and F is a number of both.
const std::string busy_text =
    "define parameter F 0.037\ndefine parameter side 24\ndefine chemical U limit 1\ndefine chemical V limit 1\n"
    "use seed 7\nuse chemical U conc 1 diff 0.2\nuse chemical V conc 0 dev 0.4 diff 0.1\ncreate matrix side 20 wrap\n"
    "rule always react U V gray-scott f F k 0.06\nrule if (RANDOM < 0.01) set V conc (RANDOM * F)\n"
    "phase \"early\" 80\nphase \"late\" 80\nuse chemical U diff 0.15\nstop at 160\noutput V colormap viridis\n";

struct Tiles {
    explicit Tiles(const std::string& text) : file(folder.write("map.pex", text)) {}

    std::vector<std::string> words(const std::string& out, const std::vector<std::string>& more) const {
        std::vector<std::string> all{"sweep", file, "--backend", "opencl", "--no-self-test", "--out", folder / out};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
    std::string csv(const std::string& out) const { return without_times(read_all(folder / (out + "/sweep.csv"))); }

    // The table of tiles that run by themselves, once it is that of batches of several sizes, too.
    std::string same(const std::vector<std::string>& more) const {
        const auto swept = [&](const std::string& out, std::vector<std::string> how) {
            how.insert(how.end(), more.begin(), more.end());
            const Outcome outcome = command(words(out, how));
            INFO(outcome.err);
            REQUIRE(outcome.exit_code == 0);
            return outcome.err;
        };
        swept("alone", {"--batch", "1"});
        CHECK_THAT(swept("three", {"--batch", "3"}), Contains("up to 3 tiles of one structure together"));
        swept("all", {"--batch", "100", "--jobs", "1"});
        CHECK(csv("three") == csv("alone"));
        CHECK(csv("all") == csv("alone"));
        CHECK(read_all(folder / "all/sheet.png") == read_all(folder / "alone/sheet.png"));
        return csv("alone");
    }

    Folder folder;
    std::string file;
};

}  // namespace

TEST_CASE("tiles of several structures, seeds and phases run together and end in the table of tiles alone") {
    const Tiles tiles(busy_text);
    const std::string table = tiles.same({"--vary", "F=0.02:0.05:3", "--vary", "side=16,24", "--replicates", "2"});
    CHECK(std::ranges::count(table, '\n') == 13);
}

TEST_CASE("tiles that break down, that are not run and that settle early leave the others of their batch alone") {
    const Tiles tiles(
        "define parameter g 0\ndefine parameter d 0.1\ndefine chemical U floor none\n"
        "use chemical U conc 1 dev 0.5 diff d\ncreate matrix 16 16 wrap\nrule always react U by (g * U * U * U)\n"
        "stop at 400\noutput U\n");
    const std::string kinds = tiles.same({"--vary", "g=0,10,0.0001", "--vary", "d=0.05,0.1,1"});
    CHECK_THAT(kinds, Contains("NaN") && Contains("unstable") && Contains("uniform"));

    std::filesystem::remove_all(tiles.folder / "alone");
    std::filesystem::remove_all(tiles.folder / "three");
    std::filesystem::remove_all(tiles.folder / "all");
    const std::string settled = tiles.same({"--vary", "d=0,0.01,0.3", "--until", "steady", "1e-3"});
    CHECK_THAT(settled, Contains("\n0,0,0,1,4,"));  // the first one after 4 iterations
}

TEST_CASE("tiles that grow run by themselves, whatever --batch says") {
    const Tiles tiles(
        "define parameter d 0.1\ndefine chemical U\nuse seed 3\nuse chemical U conc 1 dev 0.5 diff d\n"
        "create matrix 12 12 wrap\nrule every 10 always expand columns 1 rows 1\nstop at 40\noutput U\n");
    CHECK(std::ranges::count(tiles.same({"--vary", "d=0.1,0.2,0.3"}), '\n') == 4);
}

TEST_CASE("a sweep in batches that is killed goes on, and ends in the same table") {
    const Tiles tiles(busy_text);
    const std::vector<std::string> more{"--vary", "F=0.02:0.05:20", "--iterations", "8000", "--jobs", "1"};
    std::vector<std::string> batches = more;
    batches.insert(batches.end(), {"--batch", "4"});
    REQUIRE(command(tiles.words("whole", more)).exit_code == 0);
    {
        std::vector<std::string> line = tiles.words("out", batches);
        line.insert(line.begin(), test::program);
        Child child(line);
        REQUIRE(test::wait_for(tiles.folder / "out/sweep.csv", child));
        child.signal(SIGKILL);
        child.wait();
    }
    const Outcome again = command(tiles.words("out", batches));
    INFO(again.err);
    CHECK(again.exit_code == 0);
    CHECK_THAT(again.err, Contains("there already"));
    CHECK(tiles.csv("out") == tiles.csv("whole"));
}

TEST_CASE("the reference knows no batches, and a sweep that asks it for them writes nothing") {
    const Tiles tiles(busy_text);
    const Outcome outcome = command({"sweep", tiles.file, "--backend", "reference", "--batch", "4", "--vary",
                                     "F=0.02,0.04", "--out", tiles.folder / "out"});
    CHECK(outcome.exit_code == 2);
    CHECK_THAT(outcome.err, Contains("--batch 4: the reference runs each tile by itself"));
    CHECK_FALSE(std::filesystem::exists(tiles.folder / "out"));
}
