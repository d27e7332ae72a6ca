// `pelage devices`, `pelage check`, --help and --version.
#include "support/process.hpp"
#include "texts.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using Catch::Contains;
using test::command;
using test::Folder;
using test::Outcome;
using test::read_all;

TEST_CASE("check --explain says what `change` adds in a unit of time, where that is not one iteration") {
    const test::Folder folder;
    const std::string start = "define chemical U\ndefine chemical V\ncreate hex_grid 3 3\n";
    const std::string rules =
        "rule always change U conc 0.02\nrule every 4 always change U conc 0.02\nrule always change V conc U conc\n"
        "rule always change U diff 0.1\n";
    const auto said = [&](const std::string& text) {
        return test::command({"check", "--explain", folder.write("t.pex", start + text)}).out;
    };
    using Catch::Contains;

    const std::string tenth = said("define time_step 0.1\n" + rules);
    CHECK_THAT(tenth, Contains("line 5: `change U` has no time step in it: it adds 0.02 in every iteration, which is "
                               "0.2 a unit of time at time_step 0.1\n"));
    CHECK_THAT(tenth, Contains("line 6") && Contains("in every 4 iterations, which is 0.05 a unit of time"));
    CHECK_THAT(tenth, Contains("adds its value in every iteration, which is 10 times that a unit of time"));
    CHECK_THAT(tenth, !Contains("line 8"));
    CHECK_THAT(said(rules), !Contains("no time step"));
    CHECK_THAT(said(rules + "phase \"a\" 5\ndefine time_step 0.5\nphase \"b\" 5\ndefine time_step 0.25\n"),
               Contains("0.04 a unit of time at time_step 0.5, 0.08 a unit of time at time_step 0.25"));
}

TEST_CASE("devices lists a usable device with all that one wants to know") {
    const Folder folder;

    const Outcome outcome = command({"devices", "--json", folder / "devices.json"});

    INFO(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    CHECK_THAT(outcome.out, Contains("INDEX") && Contains("DRIVER") && Contains("MEMORY") && Contains("FP64"));
    const auto devices = nlohmann::json::parse(read_all(folder / "devices.json")).at("devices");
    REQUIRE_FALSE(devices.empty());
    std::size_t usable = 0;
    for (const auto& device : devices) {
        CHECK(outcome.out.find(device.at("device").get<std::string>()) != std::string::npos);
        for (const char* key :
             {"index", "platform", "version", "driver", "memory", "fp64", "correctly_rounded_division"}) {
            CHECK(device.contains(key));
        }
        if (device.at("usable")) ++usable;
        CHECK(device.at("usable") == device.at("reason").get<std::string>().empty());
    }
    CHECK(usable > 0);
}

TEST_CASE("devices works where there is no OpenCL platform") {
    const Folder folder;
    test::Surroundings bare;
    bare.environment["OCL_ICD_VENDORS"] = folder / "no drivers here";

    const Outcome outcome = command({"devices", "--json", folder / "devices.json"}, bare);

    CHECK(outcome.exit_code == 0);
    CHECK_THAT(outcome.out, Contains("No OpenCL device"));
    CHECK(nlohmann::json::parse(read_all(folder / "devices.json")).at("devices").empty());
}

TEST_CASE("devices --json that cannot be written is an error") {
    const Folder folder;

    CHECK(command({"devices", "--json", folder.path()}).exit_code == 2);
    CHECK(command({"devices", "--json", "/dev/full"}).exit_code == 2);
}

TEST_CASE("check reads all files and names every bad one") {
    const Folder folder;
    const std::string good = folder.write("good.pex", test::spots);
    const std::string bad = folder.write("bad.pex", "define chemical\n");
    const std::string worse = folder.write("worse.pex", "create nothing\n");

    const Outcome all_good = command({"check", good, good});
    const Outcome mixed = command({"check", bad, good, worse, folder / "missing.pex"});

    CHECK(all_good.exit_code == 0);
    CHECK_THAT(all_good.out, Contains("good.pex: ok: 384 cells, 2 chemicals, 2 rules, 60 iterations"));
    CHECK(all_good.err.empty());
    CHECK(mixed.exit_code == 2);
    CHECK_THAT(mixed.err, Contains("bad.pex:1:") && Contains("worse.pex:1:") && Contains("missing.pex"));
    CHECK_THAT(mixed.out, Contains("good.pex: ok"));
    CHECK(command({"check"}).exit_code == 2);
}

TEST_CASE("a file without cells may be a part: check and run say so, exit code 2 as of any mistake") {
    const Folder folder;
    const std::string hint =
        " (this file has no 'create ...'; if it is a part that others include, give an experiment that does)\n";
    const std::string part = folder.write("part.pex", "// colours\noutput rgb (A) (B) (1 - A)\n");
    const std::string chemistry = folder.write("chemistry.pex", "define chemical A\n");
    const std::string created = folder.write("created.pex", "output rgb (A) (B) (1 - A)\n create matrix 2 2\n");
    const std::string mistyped = folder.write("mistyped.pex", "define chemical A\ncraete matrix 2 2\n");

    for (const std::string verb : {"check", "run"}) {
        for (const std::string& file : {part, chemistry}) {
            const Outcome outcome = command({verb, file});
            CHECK(outcome.exit_code == 2);
            CHECK_THAT(outcome.err, Catch::EndsWith(hint));
        }
        CHECK_THAT(command({verb, part}).err, Contains("part.pex:2:13: unknown name 'A'"));
        for (const std::string& file : {created, mistyped}) CHECK_THAT(command({verb, file}).err, !Contains("a part"));
    }
}

TEST_CASE("check warns of what hardly means what it says, and --strict fails on it") {
    const Folder folder;
    const std::string good = folder.write("good.pex", test::spots);
    const std::string doubtful = folder.write("doubtful.pex", test::spots + "snap at 99\n");

    const Outcome plain = command({"check", good, doubtful});
    const Outcome strict = command({"check", "--strict", good, doubtful});

    CHECK(plain.exit_code == 0);
    CHECK_THAT(plain.out, Contains("good.pex: ok: 384 cells, 2 chemicals, 2 rules, 60 iterations\n"));
    CHECK_THAT(plain.out, Contains("doubtful.pex: ok: 384 cells, 2 chemicals, 2 rules, 60 iterations; 1 warning\n"));
    CHECK(plain.err == "pelage: " + doubtful +
                           ":11:9: warning: the snapshot at 99 never comes: the run ends at 60 [late-snapshot]\n");
    CHECK(strict.exit_code == 1);
    CHECK(strict.err == plain.err);
    CHECK(command({"check", "--strict", good}).exit_code == 0);
    CHECK(command({"check", "--strict", doubtful, folder / "missing.pex"}).exit_code == 2);
}

TEST_CASE("check refuses starts and fields that give no number, with line and column") {
    const Folder folder;
    const std::string before = "define chemical U\n  define field f (1 / (COLUMN - 2))\n";
    const std::string field = folder.write("field.pex", before + "create matrix 8 8\nrule always change U conc f\n");
    const std::string volume =
        folder.write("volume.pex", before + "create volume 8 8 2\nrule always change U conc f\n");
    const std::string start =
        folder.write("start.pex", "define chemical U\nuse chemical U conc (1 / (X - 1))\ncreate matrix 8 8\n");
    const std::string cells = folder.write(
        "cells.pex", "define chemical U\ncreate hex_grid 3 3\nset cells where (X > 0) chemical U conc (sqrt(-X))\n");

    const Outcome outcome = command({"check", field, volume, start, cells});
    const Outcome ran = command({"run", field, "--backend", "reference", "--out", folder / "out"});

    CHECK(outcome.exit_code == 2);
    CHECK(outcome.out.empty());
    CHECK(outcome.err ==
          "pelage: " + field + ":2:18: field 'f' is infinite in column 2, row 0; it must be a number everywhere\n" +
              "pelage: " + volume +
              ":2:18: field 'f' is infinite in column 2, row 0, layer 0; it must be a number everywhere\n" +
              "pelage: " + start +
              ":2:21: an expression starts 'U' with the concentration -0.125 in cell 0; it must be a number not below "
              "0\n" +
              "pelage: " + cells +
              ":3:41: an expression starts 'U' with the concentration no number in cell 2; it must be a number not "
              "below 0\n");
    CHECK_THAT(ran.err, Contains(field + ":2:18: field 'f' is infinite"));
}

TEST_CASE("check warns of what no memory holds, at the end of the run too") {
    const Folder folder;
    const std::string matrix = folder.write("matrix.pex", "define chemical U\ncreate matrix 46000 46000\n");
    const std::string volume = folder.write("volume.pex", "define chemical U\n create volume 1200 1200 1200\n");
    const std::string growing = folder.write(
        "growing.pex",
        "define chemical U\ncreate matrix 100 100\nrule every 10 always expand columns 100 rows 100\nstop at 4000\n");

    const Outcome outcome = command({"check", matrix, volume, growing});

    CHECK(outcome.exit_code == 0);
    CHECK_THAT(outcome.err, Contains(matrix + ":2:1: warning: 2116000000 cells with 1 chemical need about"));
    CHECK_THAT(outcome.err, Contains(volume + ":2:2: warning: 1728000000 cells with 1 chemical need about"));
    CHECK_THAT(outcome.err, Contains(growing + ":2:1: warning: 1608010000 cells with 1 chemical need"));
    CHECK_THAT(outcome.err, Contains("[too-large]"));
    CHECK(command({"check", "--strict", growing}).exit_code == 1);
}

TEST_CASE("check and run read an experiment from standard input, tune says that it cannot") {
    const Folder folder;
    test::Surroundings piped;
    piped.folder = folder.path();
    piped.input = test::spots;
    test::Surroundings wrong = piped;
    wrong.input = "define chemical\n";

    const Outcome checked = command({"check", "-"}, piped);
    const Outcome ran = command({"run", "-", "--backend", "reference", "--format", "csv"}, piped);
    const Outcome refused = command({"run", "-"}, wrong);
    const Outcome tuned = command({"tune", "-"}, piped);

    CHECK_THAT(checked.out, Contains("standard input: ok: 384 cells"));
    INFO(ran.err);
    CHECK(ran.exit_code == 0);
    CHECK(std::filesystem::exists(folder / "out/stdin/final.csv"));
    CHECK(refused.exit_code == 2);
    CHECK_THAT(refused.err, Contains("pelage: standard input:1:"));
    CHECK(tuned.exit_code == 2);
    CHECK_THAT(tuned.err, Contains("give a file, not standard input"));
}

TEST_CASE("every experiment of the house passes check") {
    std::vector<std::string> words{"check"};
    for (const auto& entry : std::filesystem::directory_iterator(PELAGE_SOURCE "/experiments")) {
        if (entry.path().extension() == ".pex") words.push_back(entry.path().string());
    }
    REQUIRE(words.size() > 20);

    const Outcome outcome = command(words);

    INFO(outcome.err);
    CHECK(outcome.exit_code == 0);
}

TEST_CASE("option --help names every option and --version the version") {
    const Outcome general = command({"--help"});
    const Outcome run = command({"run", "--help"});
    const Outcome version = command({"--version"});

    CHECK(general.exit_code == 0);
    CHECK_THAT(general.out, Contains("run") && Contains("devices") && Contains("check") && Contains("verify"));
    CHECK(run.exit_code == 0);
    for (const char* option :
         {"--backend", "--device", "--precision", "--iterations", "--seed", "--out", "--format", "--snap-every",
          "--checkpoint-every", "--resume", "--json", "--quiet", "--fast", "--no-cache", "--no-self-test", "--force"}) {
        CHECK_THAT(run.out, Contains(option));
    }
    CHECK(version.exit_code == 0);
    CHECK(version.out.rfind("pelage ", 0) == 0);
}

TEST_CASE("check finds charges that are missing at the start, or lie where none may") {
    const Folder folder;
    const auto checked = [&](const std::string& sites, const std::string& seed) {
        return command(
            {"check", folder.write("c.pex", "define chemical order\ndefine chemical phi\ncreate charges 9 9 " + sites +
                                                "\n" + seed + "rule always aggregate order phi\n")});
    };
    const std::string seed = "set cell 40 chemical order conc 1\n";
    CHECK(checked("", seed).exit_code == 0);
    CHECK(checked("where (X == 0)", seed).exit_code == 0);
    const Outcome none = checked("", "");
    CHECK(none.exit_code == 2);
    CHECK_THAT(none.err, Contains("no site holds a charge"));
    const Outcome outside = checked("where (X > 0)", seed);
    CHECK(outside.exit_code == 2);
    CHECK_THAT(outside.err, Contains("c.pex:3:26: 1 charge on sites that 'where' leaves out"));
}
