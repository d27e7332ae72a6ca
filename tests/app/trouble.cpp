// What the command says, and which exit code it returns, when something is wrong.
#include "support/process.hpp"
#include "texts.hpp"

#include "io/checkpoint.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <cmath>

using Catch::Contains;
using test::command;
using test::Folder;
using test::Outcome;
using test::read_all;

namespace {

// One sentence that begins with "pelage: ", nothing on standard output.
void check_refused(const Outcome& outcome, const std::string& expected) {
    INFO(outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.err.rfind("pelage: ", 0) == 0);
    CHECK_THAT(outcome.err, Contains(expected));
    CHECK(outcome.out.empty());
}

}  // namespace

TEST_CASE("a wrong command line is refused with what is allowed") {
    const Folder folder;
    const std::string file = folder.write("spots.pex", test::spots);

    check_refused(command({"grow"}), "grow");
    check_refused(command({"run"}), "FILE");
    check_refused(command({"run", file, "--backend", "cuda"}), "opencl");
    check_refused(command({"run", file, "--precision", "half"}), "double");
    check_refused(command({"run", file, "--format", "exr,jpeg"}), "jpeg");
    check_refused(command({"run", file, "--iterations", "-5"}), "--iterations");
    check_refused(command({"run", file, "--iterations", "many"}), "--iterations");
    check_refused(command({"run", file, "--iterations", "5000000000"}), "--iterations");
    check_refused(command({"run", file, "--snap-every", "0"}), "--snap-every");
    check_refused(command({"run", file, "--checkpoint-every", "0"}), "--checkpoint-every");
    check_refused(command({"run", file, "--wings"}), "--wings");
    check_refused(command({"run", file, "--backend", "reference", "--device", "0"}), "--device");
    check_refused(command({"run", file, "--backend", "reference", "--fast"}), "--fast");
}

TEST_CASE("an experiment that cannot be read is refused") {
    const Folder folder;

    check_refused(command({"run", folder / "missing.pex"}), "missing.pex");
    check_refused(command({"run", folder.path()}), folder.path().string());
    check_refused(command({"run", folder.write("empty.pex", "")}), "empty.pex");
    check_refused(
        command({"run", folder.write("bad.pex", "define chemical U\ncreate matrix 4 4\nrule always grow U\n")}),
        "bad.pex:3:");
}

TEST_CASE("a folder that cannot be written to is refused before the run") {
    const Folder folder;
    const std::string file = folder.write("spots.pex", test::spots);
    const std::vector<std::string> bad{file, file + "/below", "/proc/pelage", "/dev/null/out"};

    for (const std::string& out : bad) {
        check_refused(command({"run", file, "--backend", "reference", "--quiet", "--out", out}), out);
    }
    CHECK_THAT(command({"run", file, "--quiet", "--out", "/proc"}).err, Contains("/proc cannot be written to: "));
    const Outcome json = command(
        {"run", file, "--backend", "reference", "--quiet", "--out", folder / "out", "--json", file + "/run.json"});
    check_refused(json, file);
}

TEST_CASE("a device that is not there is refused, and nothing else takes its place") {
    const Folder folder;
    const std::string file = folder.write("spots.pex", test::spots);
    test::Surroundings bare;
    bare.environment["OCL_ICD_VENDORS"] = folder / "no drivers here";

    check_refused(command({"run", file, "--out", folder / "out", "--device", "99"}), "99");
    check_refused(command({"run", file, "--out", folder / "out", "--device", "abacus"}), "abacus");
    check_refused(command({"run", file, "--out", folder / "out", "--backend", "opencl"}, bare), "no");
    CHECK_FALSE(std::filesystem::exists(folder / "out"));
}

TEST_CASE("absurd sizes are refused before anything is allocated") {
    const Folder folder;
    const std::string chemicals = "define chemical A\ndefine chemical B\ndefine chemical C\n";
    const auto refused = [&](const std::string& text, const std::string& expected) {
        const std::string file = folder.write("big.pex", chemicals + text);
        check_refused(command({"run", file, "--out", folder / "out"}), expected);
    };

    refused("create matrix 46000 46000\n", "memory");
    refused("create matrix 100000 100000\n", "at most 2147483647");
    refused("create matrix 1000 1000\nrule always expand columns 1000\nstop at 1000000\n", "at most 2147483647");
    refused("create matrix 100 100\nrule every 10 always expand columns 100 rows 100\nstop at 4000\n", "memory");
    CHECK_FALSE(std::filesystem::exists(folder / "out"));
}

TEST_CASE("an unstable time step is refused with the largest that holds, --force goes on") {
    const Folder folder;
    const std::string file = folder.write("unstable.pex", test::unstable);

    const Outcome refused = command({"run", file, "--backend", "reference", "--out", folder / "out"});
    const Outcome forced = command({"run", file, "--backend", "reference", "--out", folder / "out", "--force"});

    check_refused(refused, "chemical 'B'");
    CHECK_THAT(refused.err,
               Contains("a rate of 3") && Contains("0.125") && Contains("it is 0.5") && Contains("--force"));
    CHECK(forced.exit_code == 0);
    CHECK(std::filesystem::exists(folder / "out" / "final.exr"));
}

TEST_CASE("the phase of an unstable time step is named") {
    const Folder folder;
    const std::string text =
        "define chemical A limit 1\ndefine time_step 0.01\nuse chemical A conc 0.5 diff 1\n"
        "create matrix 8 8\nphase \"calm\" 10\nphase \"storm\" 10\nuse chemical A diff 100\n";

    const Outcome outcome = command({"run", folder.write("phases.pex", text), "--out", folder / "out"});

    check_refused(outcome, "storm");
}

TEST_CASE("a run that meets infinity stops with iteration, chemical and first cell, and dumps the state") {
    const Folder folder;
    const std::string file = folder.write("doubling.pex", test::doubling);
    const std::string backend = GENERATE(as<std::string>(), "reference", "opencl");

    const Outcome outcome = command({"run", file, "--backend", backend, "--out", folder / "out"});

    INFO(outcome.err);
    CHECK(outcome.exit_code == 1);
    CHECK_THAT(outcome.err, Contains("chemical 'U'") && Contains("inf") && Contains("in iteration 128") &&
                                Contains("cell 10 (row 2, column 0)") && Contains("non-finite.pelage"));
    const auto dump = pelage::read_checkpoint(folder / "out" / "non-finite.pelage");
    CHECK(dump.snapshot.iteration == 128);
    CHECK(std::isinf(dump.snapshot.conc[0][10]));
    CHECK(dump.snapshot.conc[0][9] == 1.0);
    CHECK(nlohmann::json::parse(read_all(folder / "out" / "manifest.json")).at("end") == "non-finite");
    CHECK_FALSE(std::filesystem::exists(folder / "out" / "final.exr"));
}

TEST_CASE("in double the same infinity comes at iteration 1024") {
    const Folder folder;
    const std::string file = folder.write("doubling.pex", test::doubling);

    const Outcome outcome =
        command({"run", file, "--backend", "reference", "--precision", "double", "--out", folder / "out"});

    CHECK(outcome.exit_code == 1);
    CHECK_THAT(outcome.err, Contains("in iteration 1024"));
}

TEST_CASE("when the disk is full the error names the file and earlier results stay whole") {
    const Folder folder;
    const std::string file = folder.write("spots.pex", test::spots);
    const std::vector<std::string> words{"run",   file,           "--backend", "reference",
                                         "--out", folder / "out", "--format",  "csv"};
    REQUIRE(command(words).exit_code == 0);
    const std::string before = read_all(folder / "out" / "final.csv");
    test::Surroundings cramped;
    cramped.largest_file = 4096;
    std::vector<std::string> again = words;
    again.insert(again.end(), {"--seed", "8", "--quiet"});

    const Outcome outcome = command(again, cramped);

    REQUIRE(before.size() > cramped.largest_file);
    check_refused(outcome, "final.csv");
    CHECK(read_all(folder / "out" / "final.csv") == before);
    CHECK(test::names_in(folder / "out") == std::vector<std::string>{"final.csv", "manifest.json"});
}

TEST_CASE("results that cannot be written do not lose the run") {
    const Folder folder;
    const std::string file = folder.write("spots.pex", test::spots);
    std::filesystem::create_directories(folder / "out" / "final.csv");  // a folder where the file should be

    const Outcome outcome =
        command({"run", file, "--backend", "reference", "--out", folder / "out", "--format", "csv", "--quiet"});

    check_refused(outcome, "final.csv");
    CHECK_THAT(outcome.err, Contains("the state at iteration 60 is safe") && Contains("--resume"));
    CHECK(pelage::read_checkpoint(folder / "out" / "checkpoint.pelage").snapshot.iteration == 60);
}

TEST_CASE("a full device for --json is an error") {
    const Folder folder;
    const std::string file = folder.write("spots.pex", test::spots);

    const Outcome outcome =
        command({"run", file, "--backend", "reference", "--out", folder / "out", "--quiet", "--json", "/dev/full"});

    check_refused(outcome, "/dev/full");
}
