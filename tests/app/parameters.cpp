// `--set`, and `pelage check --parameters`.
#include "support/process.hpp"
#include "texts.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <cmath>
#include <set>
#include <string>
#include <vector>

using Catch::Contains;
using test::command;
using test::Folder;
using test::Outcome;
using test::read_all;

namespace {

const std::string text =
    "define parameter feed 0.04 from 0.01 to 0.09 \"what is fed\"\n"
    "define parameter end 20\n"
    "define chemical U limit 1\ndefine chemical V limit 1\n"
    "use chemical U conc 1 diff 0.16\nuse chemical V conc 0.1 dev 0.1 diff 0.08\n"
    "create matrix 20 10\n"
    "rule always react U V gray-scott f feed k 0.06\n"
    "stop at end\n";

// The same, written with the number.
std::string with(const std::string& feed) {
    std::string other = text;
    other.replace(other.find("0.04"), 4, feed);
    return other;
}

}  // namespace

TEST_CASE("what is set gives the bits of the same experiment written so, and the manifest tells") {
    const Folder folder;
    const std::string file = folder.write("named.pex", text);
    const std::string written = folder.write("written.pex", with("0.05"));

    const Outcome set =
        command({"run", file, "--set", "feed=0.05", "--set", "end=30", "--format", "csv", "--out", folder / "set"});
    const Outcome plain = command({"run", written, "--iterations", "30", "--format", "csv", "--out", folder / "plain"});

    INFO(set.err << plain.err);
    REQUIRE(set.exit_code == 0);
    REQUIRE(plain.exit_code == 0);
    CHECK(read_all(folder / "set/final.csv") == read_all(folder / "plain/final.csv"));
    const auto manifest = nlohmann::json::parse(read_all(folder / "set/manifest.json"));
    CHECK(manifest.at("iterations") == 30);
    CHECK(manifest.at("parameters").at("feed") == 0.05);
    CHECK_THAT(manifest.at("experiment").at("text").get<std::string>(), Contains("define parameter feed 0.05 from"));
    CHECK_THAT(manifest.at("options").at("set").get<std::string>(), Contains("feed=0.05"));
}

TEST_CASE("parameters drawn at random lie within their ranges, are the same for the same number, and are written") {
    const Folder folder;
    const std::string file = folder.write(
        "ranges.pex",
        "define parameter feed 0.04 from 0.01 to 0.09\ndefine parameter kill 0.06 from 0.03 to 0.07 \"killed\"\n"
        "define parameter side 12 from 8 to 20\ndefine parameter free 1\n"
        "define chemical U limit 1\ndefine chemical V limit 1\nuse chemical U conc 1 diff 0.16\n"
        "use chemical V conc (RANDOM * free) diff 0.08\ncreate matrix side (side + 1)\n"
        "rule always react U V gray-scott f feed k kill\nstop at 5\n");
    const auto run = [&](const std::vector<std::string>& more, const std::string& out) {
        std::vector<std::string> words{"run", file, "--backend", "reference", "--out", (folder / out).string()};
        words.insert(words.end(), more.begin(), more.end());
        const Outcome outcome = command(words);
        INFO(outcome.err);
        REQUIRE(outcome.exit_code == 0);
        return nlohmann::json::parse(read_all(folder / (out + "/manifest.json")));
    };
    const auto one = run({"--random", "1"}, "one").at("parameters");
    const auto again = run({"--random", "1"}, "again").at("parameters");
    const auto two = run({"--random", "2", "--set", "kill=0.05"}, "two").at("parameters");
    CHECK(one == again);
    CHECK(read_all(folder / "one/final.exr") == read_all(folder / "again/final.exr"));
    CHECK(one.at("feed") != two.at("feed"));
    CHECK(two.at("kill") == 0.05);
    CHECK(one.at("free") == 1.0);
    std::set<double> sides;
    for (int draw = 0; draw < 12; ++draw) {
        const auto drawn = run({"--random", std::to_string(draw)}, "some");
        const double side = drawn.at("parameters").at("side"), feed = drawn.at("parameters").at("feed");
        CHECK((side == std::floor(side) && side >= 8 && side <= 20 && feed >= 0.01 && feed <= 0.09));
        sides.insert(side);
    }
    CHECK(sides.size() > 4);
    const Outcome written = command({"run", (folder / "one/drawn.pex").string(), "--backend", "reference", "--format",
                                     "npy", "--out", (folder / "written").string()});
    REQUIRE(written.exit_code == 0);
    REQUIRE(command({"run", file, "--random", "1", "--backend", "reference", "--format", "npy", "--out",
                     (folder / "direct").string()})
                .exit_code == 0);
    CHECK(read_all(folder / "written/final.U.npy") == read_all(folder / "direct/final.U.npy"));
    const std::string without =
        folder.write("none.pex", "define parameter free 1\ndefine chemical U\ncreate matrix 4 free\n");
    const Outcome none = command({"run", without, "--random", "1"});
    CHECK_THAT(none.err, Contains("no parameter has a range to draw from"));
    CHECK(none.exit_code == 2);
}

TEST_CASE("another value of a parameter compiles nothing anew") {
    const Folder folder;
    const std::string file = folder.write(
        "named.pex",
        text + "define parameter wave 11\nrule always change U conc (0.01 * sin(X / wave) + RANDOM * feed)\n");
    const auto programs = [&](const std::string& feed, const std::string& wave) {
        const Outcome run = command({"run", file, "--set", "feed=" + feed, "--set", "wave=" + wave, "--explain",
                                     "--no-self-test", "--out", (folder / (feed + wave)).string()});
        INFO(run.err);
        REQUIRE(run.exit_code == 0);
        const std::size_t at = run.out.find(" compiled, ");
        REQUIRE(at != std::string::npos);
        return run.out.substr(run.out.rfind('\n', at) + 1, run.out.find('\n', at) - run.out.rfind('\n', at) - 1);
    };
    (void)programs("0.05", "11");
    const std::string again = programs("0.06", "7");
    CHECK_THAT(again, Contains(": 0 compiled, ") && !Contains(" 0 from the cache"));
}

TEST_CASE("a run is resumed with what was set, and refused with anything else") {
    const Folder folder;
    const std::string file = folder.write("named.pex", text);
    const std::string out = (folder / "out").string();
    REQUIRE(command({"run", file, "--set", "feed=0.05", "--checkpoint-every", "10", "--out", out}).exit_code == 0);

    const Outcome same =
        command({"run", file, "--set", "feed=0.05", "--resume", out + "/checkpoint.pelage", "--out", out});
    const Outcome other = command({"run", file, "--resume", out + "/checkpoint.pelage", "--out", out});

    INFO(same.err);
    CHECK(same.exit_code == 0);
    CHECK(other.exit_code == 2);
    CHECK_THAT(other.err, Contains("edited or --set otherwise since"));
}

TEST_CASE("check lists parameters for people and for programs") {
    const Folder folder;
    const std::string file = folder.write("named.pex", text);

    const Outcome told = command({"check", "--parameters", file, "--set", "feed=0.05"});
    const Outcome json = command({"check", "--parameters", "--json", file});

    CHECK(told.exit_code == 0);
    CHECK_THAT(told.out, Contains("  feed  0.05 (default 0.04) from 0.01 to 0.09: what is fed\n  end   20\n"));
    REQUIRE(json.exit_code == 0);
    const auto list = nlohmann::json::parse(json.out).at("parameters");
    REQUIRE(list.size() == 2);
    CHECK(list[0].at("name") == "feed");
    CHECK(list[0].at("default") == 0.04);
    CHECK(list[0].at("high") == 0.09);
    CHECK(list[1].at("low").is_null());
    CHECK_THAT(
        command({"check", "--parameters", folder.write("none.pex", "define chemical U\ncreate matrix 2 2\n")}).out,
        Contains("no parameters"));
}

TEST_CASE("what cannot be set is refused in a sentence") {
    const Folder folder;
    const std::string file = folder.write("named.pex", text);

    for (const char* const word : {"feed", "=1", "feed="}) {
        const Outcome outcome = command({"check", file, "--set", word});
        CHECK(outcome.exit_code == 2);
        CHECK_THAT(outcome.err, Contains("NAME=VALUE"));
    }
    CHECK_THAT(command({"check", file, "--set", "fed=1"}).err, Contains("did you mean 'feed'?"));
    CHECK_THAT(command({"run", file, "--set", "feed=1"}).err, Contains("must be a number from 0.01 to 0.09"));
    CHECK_THAT(command({"check", "--json", file}).err, Contains("--parameters"));
}
