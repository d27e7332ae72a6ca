// scripts/skipped: what is said after a test run, from the log that ctest leaves.
#include "support/process.hpp"

#include <catch2/catch.hpp>

#include <filesystem>
#include <string>

namespace {

const std::string skipped = "Test Pass Reason:\nSkip regular expression found in output. Regex=[SKIPPED: ]";

std::string entry(const std::string& number, const std::string& output, const std::string& verdict) {
    const std::string line = "----------------------------------------------------------\n";
    return number + "/4 Testing: some test\n" + number + "/4 Test: some test\nOutput:\n" + line + output +
           "<end of output>\n" + line + verdict + "\n" + line + "\n";
}

test::Outcome said_of(const std::string& log) {
    const test::Folder build;
    std::filesystem::create_directories(build / "Testing/Temporary");
    (void)build.write("Testing/Temporary/LastTest.log", log);
    return test::Child({"sh", PELAGE_SOURCE "/scripts/skipped", build.path()}).wait();
}

}  // namespace

TEST_CASE("skipped tests are counted by cause") {
    const test::Outcome outcome =
        said_of(entry("1", "SKIPPED: no data\n", skipped) + entry("2", "all well\n", "Test Passed.") +
                entry("3", "file.cpp:5: warning:\n  SKIPPED: no device\n", skipped) +
                entry("4", "SKIPPED: no data\n", skipped));

    CHECK(outcome.exit_code == 0);
    CHECK(outcome.out == "3 tests were skipped:\n     2: no data\n     1: no device\n");
    CHECK(outcome.err.empty());
}

TEST_CASE("a run without skipped tests says so, and a skipped test without a cause is counted too") {
    CHECK(said_of(entry("1", "SKIPPED: is only talked about\n", "Test Passed.")).out == "No test was skipped.\n");
    CHECK(said_of(entry("1", "", skipped)).out == "1 test was skipped:\n     1: no cause is given\n");
}
