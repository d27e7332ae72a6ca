// Parameters: where they may stand, what may be set from outside, and what the text then says.
#include "core/error.hpp"
#include "language/error_case.hpp"
#include "language/parse.hpp"
#include "language/parsed.hpp"

#include <catch2/catch.hpp>

#include <string>
#include <variant>
#include <vector>

using namespace pelage;
using namespace test;

namespace {

const std::string text =
    "define parameter feed 0.037 from 0.01 to 0.09 \"what is fed\"\n"
    "define parameter side 12\n"
    "define parameter end 2e2\n"
    "define chemical U limit side\n"
    "define chemical V\n"
    "define time_step feed\n"
    "use chemical U conc feed dev feed diff feed\n"
    "create matrix side side wrap\n"
    "rule from side until end if U conc < feed react U V gray-scott f feed k 0.06\n"
    "snap at side\n"
    "stop at end\n";

Experiment set_to(const std::vector<Setting>& settings) {
    return parse_experiment(text, "t.pex", "/nowhere", nullptr, StartPictures::read, settings);
}

std::string refusal(const std::vector<Setting>& settings) {
    try {
        (void)set_to(settings);
        return "(none)";
    } catch (const Error& error) {
        return error.what();
    }
}

}  // namespace

TEST_CASE("a parameter stands wherever a number stands") {
    const Experiment e = parsed(text);

    REQUIRE(e.parameters.size() == 3);
    CHECK(e.parameters[0].name == "feed");
    CHECK(e.parameters[0].value == 0.037);
    CHECK(e.parameters[0].low == 0.01);
    CHECK(e.parameters[0].high == 0.09);
    CHECK(e.parameters[0].meaning == "what is fed");
    CHECK(e.parameters[1].line == 2);
    CHECK(e.chemicals.at(0).bounds.limit == 12);
    CHECK(e.phases.at(0).time_step == 0.037);
    CHECK(e.stop_at == 200);
    CHECK(e.snap_at == std::vector<std::uint64_t>{12});
    const Rule& rule = e.rules.at(0);
    CHECK(rule.from == 12);
    CHECK(rule.until == 200);
    CHECK(std::get<Compare>(rule.condition).right.value == 0.037);
    CHECK(std::get<React>(rule.action).parameters.at(0).value == 0.037);
    const auto& matrix = std::get<CreateMatrix>(e.prepattern.back());
    CHECK(matrix.columns == 12);
    CHECK(matrix.rows == 12);
}

TEST_CASE("what is set from outside counts, and stands in the text that is kept") {
    const Experiment e = set_to({{"feed", "0.05"}, {"side", "7"}, {"feed", "6e-2"}});

    CHECK(e.parameters[0].value == 0.06);
    CHECK(e.parameters[0].usual == 0.037);
    CHECK(std::get<CreateMatrix>(e.prepattern.back()).columns == 7);
    const Experiment again = parsed(e.text);
    CHECK(again.parameters[0].value == 0.06);
    CHECK(again.parameters[1].value == 7);
    CHECK(again.phases.at(0).time_step == e.phases.at(0).time_step);
    CHECK(again.text == e.text);
    CHECK(set_to({}).text == text);
}

TEST_CASE("settings that cannot be are refused with what may be") {
    CHECK(refusal({{"fed", "1"}}) ==
          "--set fed=1: t.pex defines no parameter of that name; defined there: feed, side, end; did you mean 'feed'?");
    CHECK(refusal({{"feed", "0.5"}}) == "--set feed=0.5: parameter 'feed' must be a number from 0.01 to 0.09");
    CHECK(refusal({{"feed", "much"}}) == "--set feed=much: the value must be a number");
    CHECK(refusal({{"side", "7.5"}}) ==
          "t.pex:8:15: parameter 'side' of line 2 is 7.5, which is not a whole number; the number of columns must be a "
          "whole number from 1 to 2147483647");
    CHECK_THROWS_WITH(parse_experiment(grid, "t.pex", "/nowhere", nullptr, StartPictures::read, {{"k", "1"}}),
                      "--set k=1: t.pex defines no parameter of that name; it defines none");
}

TEST_CASE("malformed parameters say where and what is allowed") {
    const ErrorCase cases[] = {
        {grid, "define parameter",
         "t.pex:4:17: the line ends too early; the parameter's name must be a word without quotes"},
        {grid, "define parameter p", "t.pex:4:19: the line ends too early; the parameter must be a number"},
        {grid, "define parameter p q", "t.pex:4:20: 'q' is not a number; the parameter must be a number"},
        {grid, "define parameter U 1", "t.pex:4:18: 'U' is a chemical; choose another name"},
        {grid, "define parameter AGE 1", "t.pex:4:18: 'AGE' cannot name a parameter; it is a word of rules"},
        {grid, "define parameter none 1", "t.pex:4:18: 'none' cannot name a parameter; it is a word beside numbers"},
        {grid, "define parameter 1p 1",
         "t.pex:4:18: '1p' cannot name a parameter; names are a letter, then up to 31 letters, digits, _ or -"},
        {grid, "define parameter p 1 from 2 to 3", "t.pex:4:20: '1' is not from 2 to 3"},
        {grid, "define parameter p 1 from 3 to 2", "t.pex:4:27: the lowest value 3 is above the highest, 2"},
        {grid, "define parameter p 1 from 0", "t.pex:4:28: the line ends too early; allowed here: to"},
        {grid, "define parameter p 1 what",
         "t.pex:4:22: 'what' has no quotes; what the parameter means must be a text in double quotes"},
        {"define parameter p 1\n" + grid, "define parameter p 2", "t.pex:5:18: parameter 'p' is defined already"},
        {"define parameter p 1\n" + grid, "define chemical p", "t.pex:5:17: 'p' is a parameter; choose another name"},
        {"define parameter p 1\n" + grid, "rule always map U conc 0 1 to p 0 1",
         "t.pex:5:31: 'p' is a parameter; choose another name"},
        {"define parameter pace -1\n" + grid, "define time_step pace",
         "t.pex:5:18: parameter 'pace' of line 1 is -1, which is out of range; the time step must be a number above 0"},
        {"define parameter pace 1\n" + grid, "define time_step pac",
         "t.pex:5:18: 'pac' is not a number; the time step must be a number above 0; did you mean 'pace'?"},
        {"define parameter p 1e16\n" + grid, "use seed p",
         "t.pex:5:10: parameter 'p' of line 1 is 1e+16, which is too large to be exact; the seed must be a whole "
         "number"}};
    for (const ErrorCase& one : cases) check_error(one);
}
