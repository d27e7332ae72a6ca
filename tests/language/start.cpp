// How a tissue may not start: refused with line and column; what published files do is not.
#include "core/error.hpp"
#include "core/starts.hpp"
#include "language/error_case.hpp"
#include "language/parse.hpp"
#include "support/shared.hpp"

#include <catch2/catch.hpp>

#include <filesystem>
#include <string>
#include <vector>

using namespace pelage;
using Catch::Matchers::Contains;
using test::message_of;

namespace {

const std::string bounded = "define chemical U floor 1 limit 5\ndefine chemical V\n";

// What is odd about the start of an experiment that parses.
std::vector<std::string> oddities(const Experiment& experiment) {
    std::vector<std::string> texts;
    for (const StartFault& fault : start_faults(experiment)) texts.push_back(fault.text);
    return texts;
}

std::vector<std::string> oddities(const std::string& text) {
    return oddities(parse_experiment(text, "t.pex", "/nowhere"));
}

}  // namespace

TEST_CASE("a rate below 0 is refused on a lattice, and a draw that may give one anywhere") {
    const std::string chemical = "define chemical A\n";
    CHECK_THAT(message_of(chemical + "use chemical A conc 1 diff -0.1\ncreate matrix 4 4\n"),
               Contains("t.pex:2:28: the diffusion rate -0.1 of 'A' is below 0; on a lattice"));
    CHECK_THAT(message_of(chemical + "use chemical A diff 0.05 dev 0.1\ncreate cell 0 0\n"),
               Contains("t.pex:2:21: the diffusion rate of 'A' is drawn from -0.05 to 0.15"));
    CHECK_THAT(message_of(chemical + "create matrix 4 4\nset cells 0 to 3 chemical A conc 1 diff -1\n"),
               Contains("t.pex:3:41: the diffusion rate -1 of 'A'"));
    CHECK_THAT(message_of(chemical + "create matrix 4 4\nphase \"a\" 10\nuse chemical A diff -1\n"),
               Contains("t.pex:4:21: '-1' is out of range; the diffusion rate must be a number not below 0"));
    CHECK(oddities(chemical + "use chemical A diff -0.01\ncreate cell 0 0\ncreate cell 2 0\n").size() == 1);
}

TEST_CASE("a start outside the bounds of the first phase is refused") {
    CHECK_THAT(message_of(bounded + "use chemical U diff 1 conc 6\ncreate matrix 4 4\n"),
               Contains("t.pex:3:28: 'U' starts at 6, outside its bounds 1 to 5"));
    CHECK_THAT(message_of(bounded + "create matrix 4 4\n"),
               Contains("t.pex:3:8: 'U' starts at 0, outside its bounds 1 to 5; write 'use chemical U conc VALUE'"));
    CHECK_THAT(message_of(bounded + "use chemical U conc 3\nuse chemical V conc -1\ncreate matrix 4 4\n"),
               Contains("t.pex:4:21: 'V' starts at -1, outside its floor 0"));
    const std::string moved = "use chemical U conc 4\ncreate matrix 4 4\nphase \"a\" 5\ndefine chemical U limit 3\n";
    CHECK_THAT(message_of(bounded + moved), Contains("t.pex:3:21: 'U' starts at 4, outside its bounds 1 to 3"));
    const std::string later =
        "use chemical U conc 4\ncreate matrix 4 4\nphase \"a\" 5\nphase \"b\" 5\n"
        "define chemical U limit 3\n";
    CHECK(message_of(bounded + later) == "(none)");
    const auto partly = oddities(bounded + "use chemical U conc 4 dev 2\ncreate matrix 4 4\n");
    REQUIRE(partly.size() == 1);
    CHECK(partly[0] ==
          "'U' starts between 2 and 6, partly outside its bounds 1 to 5; the first iteration "
          "cuts what is");
}

TEST_CASE("a time step, a length or an interval that is 0 in float is refused, infinity too") {
    const std::string end = "define chemical U\ncreate matrix 4 4\n";
    CHECK_THAT(message_of("define time_step 1e-50\n" + end),
               Contains("t.pex:1:18: '1e-50' is 0 in float; the time step must be a number above 0"));
    CHECK_THAT(message_of("define time_step 1e-40\n" + end),
               Contains("t.pex:1:18: '1e-40' is 0 in float; the time step must be at least 1.18e-38"));
    CHECK_THAT(message_of("define domain 1e-50 5\n" + end),
               Contains("t.pex:1:15: '1e-50' is 0 in float; the domain's width"));
    CHECK_THAT(message_of(end + "rule always map X 1 1.000000001 to M 0 1\n"), Contains("the interval is empty"));
    CHECK_THAT(message_of("define time_step +inf\n" + end), Contains("'+inf' is not finite"));
    CHECK_THAT(message_of(end + "rule always change U conc +inf\n"), Contains("'+inf' is not finite"));
}

TEST_CASE("seeds and counts that 64 bits do not hold are refused, not cut") {
    CHECK_THAT(message_of("define chemical U\nuse seed 99999999999999999999\ncreate matrix 4 4\n"),
               Contains("t.pex:2:10: '99999999999999999999' is out of range"));
    CHECK_THAT(message_of("define chemical U\nuse seed 1.5\ncreate matrix 4 4\n"), Contains("is not a whole number"));
    CHECK_THAT(message_of("define chemical U\ncreate matrix 4 18446744073709551617\n"), Contains("is out of range"));
    CHECK_THAT(message_of("define chemical U\ncreate matrix 4 4\nstop at 4294967296\n"), Contains("is out of range"));
    CHECK_THAT(message_of("define chemical U\ncreate matrix 4 4\nset cell 4294967296 fixed\n"),
               Contains("is out of range"));
}

TEST_CASE("every published file still parses, those that pump or draw past a bound are odd") {
    if (test::shared_missing("pex")) return;
    std::size_t files = 0, pumping = 0, drawing = 0, others = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(test::shared("pex"))) {
        if (entry.path().extension() != ".pex" || entry.path().filename() == "activation-18-automata-3.pex") continue;
        ++files;
        for (const std::string& odd : oddities(parse_experiment_file(entry.path()))) {
            const bool pumps = odd.find("below 0; such cells pump") != std::string::npos;
            const bool draws = odd.find("partly outside") != std::string::npos;
            pumping += pumps ? 1 : 0;
            drawing += draws ? 1 : 0;
            others += pumps || draws ? 0 : 1;
        }
    }
    CHECK(files > 80);
    CHECK(pumping == 1);
    CHECK(drawing == 6);
    CHECK(others == 0);
}
