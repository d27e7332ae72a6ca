// Output that cannot be printed never ends a run, and is an error where it is all that was asked for.
#include "support/process.hpp"
#include "texts.hpp"

#include "io/checkpoint.hpp"

#include <catch2/catch.hpp>

#include <csignal>
#include <filesystem>
#include <string>

using Catch::Contains;
using test::Child;
using test::Folder;
using test::Outcome;
using test::program;
using test::read_all;
using test::shell;

namespace {}  // namespace

TEST_CASE("a run whose output cannot be printed writes all its results") {
    const Folder folder;
    const std::string file = folder.write("spots.pex", test::spots);
    const auto run = [&](const std::string& name, const std::string& redirected) {
        return shell(program + " run " + file +
                     " --backend reference --explain --checkpoint-every 20 --format csv --out " +
                     (folder / name).string() + " " + redirected);
    };
    REQUIRE(run("whole", "").exit_code == 0);
    const auto names = test::names_in(folder / "whole");
    const std::string redirected =
        GENERATE(as<std::string>(), "2>&-", "2>/dev/full", ">&-", ">/dev/full", "<&- >&- 2>&-", ">/dev/full 2>&1");

    const Outcome outcome = run("cut", redirected);

    INFO(redirected << ": " << outcome.err);
    CHECK(outcome.exit_code == 0);
    CHECK(test::names_in(folder / "cut") == names);
    CHECK(read_all(folder / "cut" / "final.csv") == read_all(folder / "whole" / "final.csv"));
}

TEST_CASE("a run that is stopped saves its checkpoint though nothing can be printed") {
    const Folder folder;
    const std::string file = folder.write("spots.pex", test::spots);
    Child child({"sh", "-c",
                 "exec " + program + " run " + file + " --backend reference --iterations 60000 --checkpoint-every " +
                     "500 --out " + (folder / "out").string() + " >/dev/full 2>&1"});
    REQUIRE(test::wait_for(folder / "out" / "checkpoint.pelage", child));

    child.signal(SIGTERM);

    CHECK(child.wait().exit_code == 130);
    CHECK(pelage::read_checkpoint(folder / "out" / "checkpoint.pelage").snapshot.iteration >= 500);
}

TEST_CASE("errors keep their exit code though nobody can read them") {
    const Folder folder;
    const std::string unstable = folder.write("unstable.pex", test::unstable);
    const std::string closed = GENERATE(as<std::string>(), "2>&-", "2>/dev/full");

    CHECK(shell(program + " run " + unstable + " " + closed).exit_code == 2);
    CHECK(shell(program + " check " + folder.write("bad.pex", "grow\n") + " " + closed).exit_code == 2);
    CHECK(shell(program + " wings " + closed).exit_code == 2);
}

TEST_CASE("what was asked for and cannot be printed is an error, a reader that has seen enough is none") {
    const Folder folder;
    const std::string file = folder.write("spots.pex", test::spots);

    const std::string full = GENERATE(as<std::string>(), " >/dev/full", " >&-");
    for (const std::string& words : {"check --explain " + file, "check " + file, std::string("--version"),
                                     std::string("--help"), std::string("run --help"), std::string("help run"),
                                     std::string("completion bash"), std::string("verify --list")}) {
        const Outcome outcome = shell(program + " " + words + full);
        INFO(words << full << ": " << outcome.err);
        CHECK(outcome.exit_code == 2);
        CHECK_THAT(outcome.err, Contains("standard output cannot be written"));
    }
    const Outcome enough = shell("{ sleep 0.2; " + program + " check --explain " + file + "; echo $? >" +
                                 (folder / "code").string() + "; } | true");
    CHECK(read_all(folder / "code") == "0\n");
    CHECK(enough.err.empty());
}

TEST_CASE("a limit on file sizes is told in a sentence") {
    const Folder folder;
    const std::string file = folder.write("spots.pex", test::spots);
    const auto limited = [&](const std::string& options) {
        return shell("ulimit -f 4; " + program + " run " + file + " --quiet --format csv --out " +
                     (folder / "out").string() + options);
    };

    const Outcome reference = limited(" --backend reference");
    CHECK(reference.exit_code == 2);
    CHECK_THAT(reference.err, Contains("final.csv") && Contains("File too large"));
    const Outcome opencl = limited(" --backend opencl");
    CHECK(opencl.exit_code == 2);
    CHECK_THAT(opencl.err, Contains("ulimit -f"));
}

// The functions that stop the program, or may, when they cannot print.
TEST_CASE("the command prints only by what cannot fail") {
    for (const auto& entry :
         std::filesystem::directory_iterator(std::filesystem::path(PELAGE_SOURCE) / "host" / "app")) {
        if (entry.path().stem() == "say") continue;
        const std::string text = read_all(entry.path());
        for (const char* call : {"fmt::print", "std::cout", "std::cerr", "std::clog", "fputs(", "printf(", "std::puts(",
                                 "fflush(stdout"}) {
            INFO(entry.path() << " has " << call << "; app/say.hpp prints");
            CHECK(text.find(call) == std::string::npos);
        }
    }
}
