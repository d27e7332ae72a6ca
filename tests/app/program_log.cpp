// PELAGE_PROGRAMS_LOG, by which tests/coverage sees what of the kernels was used.
#include "support/process.hpp"

#include <catch2/catch.hpp>

#include <filesystem>
#include <string>

using Catch::Contains;

TEST_CASE("the text of each program and the name of each kernel that is launched are kept where they are asked for") {
    const test::Folder folder;
    const auto log = folder / "log";
    std::filesystem::create_directory(log);
    test::Surroundings logging;
    logging.environment["PELAGE_PROGRAMS_LOG"] = log.string();
    const std::string experiment =
        folder.write("t.pex", "define chemical U\nuse chemical U conc 1 dev 1 diff 0.1\ncreate matrix 9 7 wrap\n");

    const auto outcome = test::command({"run", experiment, "--iterations", "3", "--out", folder / "out"}, logging);

    INFO(outcome.out << outcome.err);
    REQUIRE(outcome.exit_code == 0);
    std::size_t programs = 0;
    for (const std::string& name : test::names_in(log)) {
        if (std::filesystem::path(name).extension() != ".cl") continue;
        const std::string text = test::read_all(log / name);
        if (text.find("PELAGE_WRAP") == std::string::npos) continue;
        ++programs;
        CHECK_THAT(text.substr(0, text.find('\n')), Catch::StartsWith("// -cl-std=CL1.2 "));
        CHECK_THAT(text, Contains("kernel void pelage_lattice_step("));
    }
    CHECK(programs > 0);
    CHECK(std::filesystem::exists(log / "pelage_lattice_step.launched"));
}

TEST_CASE("a folder for programs that is not there is told") {
    const test::Folder folder;
    test::Surroundings logging;
    logging.environment["PELAGE_PROGRAMS_LOG"] = folder / "none";

    const auto outcome = test::command({"verify", "--filter", "random/known"}, logging);

    CHECK(outcome.exit_code == 1);
    CHECK_THAT(outcome.out, Contains((folder / "none").string()));
}
