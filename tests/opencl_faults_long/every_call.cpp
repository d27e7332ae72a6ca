// Every single OpenCL call of some runs is made to fail, one after the other: minutes of work.
#include "opencl_faults/every_call.hpp"
#include "opencl_faults/codes.hpp"

#include <catch2/catch.hpp>

TEST_CASE("a run survives the failure of each of its OpenCL calls, or says which one failed") {
    const auto play = GENERATE(from_range(test::all_plays));
    const auto& codes = test::standard_codes();
    test::Stage stage(play);
    const std::vector<test::Call> calls = test::calls_of_a_good_run(stage);
    REQUIRE(calls.size() > 500);

    std::size_t struck = 0;
    for (std::size_t nth = 0; nth < calls.size(); ++nth) {
        if (test::check_failing_call(stage, nth, codes[nth % codes.size()])) ++struck;
    }

    CHECK(struck > calls.size() * 9 / 10);
    test::Faults::layer().reset();
}
