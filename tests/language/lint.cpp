// Warnings: each lint finds what it looks for, where it stands, and is silent where all is well.
#include "language/lint.hpp"
#include "core/space.hpp"
#include "language/parse.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <optional>
#include <set>
#include <string>
#include <vector>

using Catch::Contains;

namespace {

// Two chemicals on 8 x 4 cells that react for 100 iterations: nothing is wrong with them.
const std::string sound =
    "define chemical U limit 5\n"
    "define chemical V\n"
    "define time_step 0.01\n"
    "use chemical U conc 4 diff 5\n"
    "use chemical V conc 4 diff 1\n"
    "create matrix 8 4\n"
    "rule always react U V turing alpha 16 beta 12\n"
    "stop at 100\n";  // line 8

std::vector<pelage::Warning> warnings(const std::string& text, std::optional<std::uint64_t> last = {},
                                      const std::filesystem::path& folder = ".") {
    pelage::Outline outline;
    const pelage::Experiment experiment = pelage::parse_experiment(text, "t.pex", folder, &outline);
    return lint(experiment, outline, last.value_or(experiment.last_iteration()));
}

// "LINE:COLUMN LINT", separated by commas.
std::string found(const std::string& text) {
    std::vector<std::string> list;
    for (const pelage::Warning& one : warnings(text))
        list.push_back(fmt::format("{}:{} {}", one.line, one.column, one.lint));
    return fmt::format("{}", fmt::join(list, ", "));
}

std::string after_sound(const std::string& line) { return found(sound + line); }

std::string text_of(const std::string& line) {
    const auto all = warnings(sound + line);
    REQUIRE(all.size() == 1);
    return all.front().text;
}

std::string replaced(std::string text, const std::string& what, const std::string& with) {
    const std::size_t at = text.find(what);
    REQUIRE(at != std::string::npos);
    return text.replace(at, what.size(), with);
}

const std::string tissue =
    "define chemical U\n"
    "define domain 20 10\n"
    "use chemical U conc 1\n";

}  // namespace

TEST_CASE("an experiment that means what it says gives no warning") {
    CHECK(found(sound).empty());
    CHECK(after_sound("rule from 20 until 50 every 10 offset 30 always change U conc 1\n").empty());
    CHECK(after_sound("rule from 99 always change U conc 1\n").empty());
    CHECK(after_sound("snap at 0 100\nsnap from 0 repeat 11 step 10 then exit\n").empty());
    CHECK(after_sound("output U colormap viridis\noutput V range 0 1\noutput U range 0 1\n").empty());
    CHECK(after_sound("colormap slot 1 use rgb 0 0 0\noutput U colormap striped\n").empty());
}

TEST_CASE("everything that a file defines has a line, also what comes with its end") {
    // What `previous(V)` was an iteration ago is a chemical of its own, with a start and a rule.
    const std::string text = sound + "rule if (V - previous(V) > 0.1) change V conc 0.01\n";
    pelage::Outline outline;
    const pelage::Experiment experiment = pelage::parse_experiment(text, "t.pex", ".", &outline);

    REQUIRE(experiment.prepattern.size() == 4);
    CHECK(outline.prepattern == std::vector<std::size_t>{4, 5, 6, 9});
    CHECK(outline.chemicals == std::vector<std::size_t>{1, 2, 9});
    CHECK(outline.mappings.size() == experiment.mappings.size());
}

TEST_CASE("rules whose time never comes") {
    CHECK(after_sound("rule from 50 until 20 always change U conc 1\n") == "9:1 idle-rule");
    CHECK(after_sound("  rule from 100 always change U conc 1\n") == "9:3 idle-rule");
    CHECK(after_sound("rule every 10 offset 100 always change U conc 1\n") == "9:1 idle-rule");
    CHECK(after_sound("rule every 7 from 8 until 13 always change U conc 1\n") == "9:1 idle-rule");
    CHECK(text_of("rule from 50 until 20 always change U conc 1\n") ==
          "this rule never acts: it would begin at 50, after its last iteration 20");
    CHECK(text_of("rule from 200 always change U conc 1\n") ==
          "this rule never acts: it would begin at 200, and the run ends at 100");
    CHECK_THAT(text_of("rule from 200 always and\nrule always change U conc 1\n"), Contains("its 'and' joins"));
    const std::string phased = replaced(sound, "stop at 100\n", "phase \"a\" 10\n");
    CHECK(found(phased + "rule from 10 always change U conc 1\n") == "9:1 idle-rule");
    CHECK(found(phased + "rule until 10 always change U conc 1\n").empty());
}

TEST_CASE("phases and snapshots that the run does not reach") {
    const std::string phases = "phase \"a\" 10\nphase \"b\" 10\nrule always change U conc 1\nstop at 10\n";
    CHECK(found(replaced(sound, "stop at 100\n", phases)) == "9:1 idle-phase");
    CHECK(after_sound("snap at 50 101 7 200\n") == "9:12 late-snapshot, 9:18 late-snapshot");
    CHECK(after_sound("snap from 91 repeat 3 step 5\n") == "9:11 late-snapshot");
    CHECK_THAT(text_of("snap from 91 repeat 3 step 5\n"), Contains("1 of the 3 snapshots"));
    CHECK(warnings(sound + "snap at 150\n", 150).empty());
}

TEST_CASE("conditions that cannot hold") {
    const auto judged = [](const std::string& condition) {
        return !after_sound("rule " + condition + " change U conc 1\n").empty();
    };
    for (const char* never :
         {"if U conc > 5", "if U conc < 0", "if U conc == -1", "if U conc in 3 2", "if U conc in 6 7", "if ROW == 4",
          "if ROW == 0.5", "if ROW > ROWS", "if COLUMNS != 8", "if ITERATION >= 100", "if NEIGHBORS < 0",
          "if RANDOM >= 1", "if AGE == -1", "if 1 == 2", "if V conc != V conc", "probability 0",
          "from 50 if ITERATION < 50", "until 9 if ITERATION == 10"}) {
        INFO(never);
        CHECK(judged(never));
    }
    for (const char* sometimes :
         {"if U conc >= 5", "if U conc == 0", "if V conc > 1000", "if U diff < 0", "if ROW == 3", "if X < -1000",
          "if ROW < ROWS", "if ITERATION == 99", "if RANDOM != RANDOM", "if RANDOM > 0.999", "if V conc == V conc",
          "probability 0.001", "probability U conc", "from 50 if ITERATION == 50", "if U conc < V conc"}) {
        INFO(sometimes);
        CHECK_FALSE(judged(sometimes));
    }
    CHECK(after_sound("rule every 2 if U conc > 5 change U conc 1\n") == "9:14 impossible");
    CHECK(text_of("rule if U conc > 5 change U conc 1\n") ==
          "this rule never acts: the value compared is from 0 to 5, the other one is 5");
    const std::string grown = sound + "rule every 10 always expand rows 1\n";
    CHECK(found(grown + "rule if ROW == 10 change U conc 1\n").empty());
    CHECK(after_sound("rule always map U conc 0 1 to M 2 3\nrule if M < 2 change U conc 1\n").empty());
    CHECK(after_sound("rule always map U conc 0 1 to M 2 3\nrule if M > 3 change U conc 1\n") == "10:6 impossible");
    CHECK(after_sound("rule if V conc > 1 and\n") == "9:20 dangling-and");
}

TEST_CASE("a wider bound in a phase keeps a condition possible") {
    const std::string phased = replaced(sound, "stop at 100\n", "rule if U conc > 5 change U conc 1\nphase \"a\" 10\n");
    CHECK(found(phased) == "8:6 impossible");
    CHECK(found(phased + "define chemical U limit 6\n").empty());
}

TEST_CASE("settings that a later line replaces") {
    CHECK(after_sound("stop at 200\n") == "9:1 repeated");
    CHECK_THAT(text_of("stop at 200\n"), Contains("'stop at' stands in line 8 already"));
    CHECK(after_sound("zoom level 1\nzoom level 2\nzoom level 3\n") == "10:1 repeated, 11:1 repeated");
    const std::string phases = "phase \"a\" 10\ndefine time_step 0.01\nphase \"b\" 10\ndefine time_step 0.01\n";
    CHECK(found(replaced(sound, "stop at 100\n", phases)).empty());
    CHECK(found(replaced(sound, "stop at 100\n", phases + "define time_step 0.02\n")) == "12:1 repeated");
}

TEST_CASE("time steps that diffusion does not bear") {
    CHECK(found(replaced(sound, "diff 5", "diff 40")) == "4:23 unstable");
    CHECK(found(replaced(sound, "diff 5", "diff 20 dev 20")) == "4:23 unstable");
    CHECK(found(replaced(sound, "diff 5", "diff 37")).empty());
    CHECK(after_sound("set cell 3 chemical V diff 40\n") == "9:23 unstable");
    const std::string phased = replaced(sound, "stop at 100\n", "phase \"a\" 10\nphase \"b\" 10\n");
    CHECK(found(phased + "use chemical U diff 40\n") == "10:16 unstable");
    CHECK(found(phased + "define time_step 1\n") == "10:1 unstable");
}

TEST_CASE("what comes too late for the cells") {
    const std::string late = replaced(sound, "use chemical V conc 4 diff 1\n", "");
    CHECK(found(late + "use chemical V conc 4 diff 1\n") == "8:1 late-use");
    CHECK_THAT(warnings(late + "use chemical V conc 4\n").front().text, Contains("'V' starts at 0"));
    CHECK_THAT(text_of("use chemical V conc 3\n"), !Contains("starts at 0"));
    CHECK(after_sound("use polarity 45\n") == "9:1 late-use");
}

TEST_CASE("cells beyond the domain") {
    CHECK(found(tissue + "create cell 10 5\ncreate cell -10 -5\n").empty());
    CHECK(found(tissue + "create cell 0 0\n  create cell 10 5.1\n") == "5:3 outside");
    CHECK(found(tissue + "create hex_grid 12 3\n") == "4:1 outside");
    CHECK(found("define chemical U\ndefine domain packed\ncreate hex_grid 20 2\n") == "3:1 outside");
    CHECK(found(tissue + "create matrix 100 100\n").empty());
}

TEST_CASE("shapes that are no drawings") {
    const std::filesystem::path folder = std::filesystem::temp_directory_path();
    std::ofstream(folder / "pelage-lint.obj") << "o cube\nv 1 2 3\nf 1 2 3\n";
    std::ofstream(folder / "pelage-lint.txt") << "..AB..\n.AABB.\n";
    std::ofstream(folder / "pelage-lint-numbers.txt") << "1.5 2.25 x\n3 4 y\n";
    const auto lints = [&](const std::string& file) {
        std::string text;
        for (const pelage::Warning& one : warnings("define chemical U\ncreate shape \"" + file + "\"\n", {}, folder))
            text += fmt::format("{}:{} {}", one.line, one.column, one.lint);
        return text;
    };

    CHECK(lints("pelage-lint.obj") == "2:14 no-shape");
    CHECK(lints("pelage-lint-numbers.txt") == "2:14 no-shape");
    CHECK(lints("pelage-lint.txt").empty());
}

TEST_CASE("what is described and not needed") {
    CHECK(found("define chemical W\n" + sound + "output U\n") == "1:17 unused-chemical");
    CHECK(found("define chemical W\n" + sound).empty());  // drawn as the first one
    CHECK(after_sound("rule always map U conc 0 1 to M 2 3\n") == "9:31 unused-mapping");
    CHECK(after_sound("rule always map U conc 0 1 to M 2 3\nrule probability M change U conc 1\n").empty());
    CHECK(after_sound("colormap slot 1 use rgb 0 0 0\ncolormap slot 2 use rgb 9 9 9\n") == "9:1 unused-colour");
    CHECK(after_sound("colormap select inferno\noutput U colormap gray\n") == "9:1 unused-colour");
    CHECK(after_sound("output U\noutput U colormap heat\n") == "10:1 equal-outputs");
    CHECK(after_sound("output U\noutput U height\noutput U normal 1\noutput U range each\n").empty());
    CHECK(after_sound("output U range each\noutput U range 0 1\n").empty());
}

TEST_CASE("places count characters, behind a byte order mark and in lines that end as on Windows too") {
    const std::string windows = "\xef\xbb\xbf" + replaced(sound, "limit 5\n", "limit 5 // \xc3\xa4\r\n");
    CHECK(found(windows + "rule if U conc > 5 change U conc 1\r\n") == "9:6 impossible");
}

TEST_CASE("starts that only published experiments have are odd") {
    CHECK(found(replaced(sound, "conc 4 diff 5", "conc 4 dev 2 diff 5")) == "4:16 odd-start");
}

TEST_CASE("a warning is shown with file, line and column") {
    pelage::Outline outline;
    const pelage::Experiment experiment = pelage::parse_experiment(sound + "stop at 200\n", "dir/t.pex", ".", &outline);
    const auto all = lint(experiment, outline, 200);

    REQUIRE(all.size() == 1);
    CHECK(shown(experiment, all[0]) ==
          "dir/t.pex:9:1: warning: 'stop at' stands in line 8 already; this line replaces it [repeated]");
}

TEST_CASE("the experiments of the house give the one warning that the published tissue deserves") {
    std::vector<std::string> given;
    for (const auto& entry :
         std::filesystem::directory_iterator(std::filesystem::path(PELAGE_SOURCE) / "experiments")) {
        if (entry.path().extension() != ".pex") continue;
        pelage::Outline outline;
        const pelage::Experiment experiment = pelage::parse_experiment_file(entry.path(), &outline);
        for (const pelage::Warning& one : lint(experiment, outline, experiment.last_iteration())) {
            // The published coats draw 4 +- 2 whatever the limit, and their first iteration cuts what is above.
            if (one.text.find("partly outside its bounds") != std::string::npos) continue;
            given.push_back(entry.path().stem().string() + " " + one.lint + ": " + one.text);
        }
    }

    INFO(fmt::format("{}", fmt::join(given, "\n")));
    CHECK(given.size() == 1);
    CHECK(given.front().rfind("leopard-of-cells outside", 0) == 0);  // 335 cells; the published program moves them in
}
