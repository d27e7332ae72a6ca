// A call from each place in the program that calls OpenCL is made to fail.
#include "codes.hpp"
#include "every_call.hpp"

#include <catch2/catch.hpp>

#include <set>

TEST_CASE("a run survives the failure of an OpenCL call from each place in the program, or says which one failed") {
    const auto& codes = test::standard_codes();
    std::set<std::size_t> places;
    std::size_t turn = 0;

    std::size_t struck = 0;
    std::size_t missed = 0;
    for (const test::Stage::Play play : test::all_plays) {
        test::Stage stage(play);
        const std::vector<test::Call> calls = test::calls_of_a_good_run(stage);
        for (std::size_t nth = 0; nth < calls.size(); ++nth) {
            if (!places.insert(calls[nth].site).second) continue;
            if (calls[nth].name == "clSetKernelArg" && turn++ % 4 != 0) continue;  // hundreds that are all alike
            ++(test::check_failing_call(stage, nth, codes[turn++ % codes.size()]) ? struck : missed);
        }
    }

    CHECK(struck > 500);
    CHECK(missed < struck / 10);
    test::Faults::layer().reset();
}
