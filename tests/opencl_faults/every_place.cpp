// A call from each sixth place in the program that calls OpenCL is made to fail; from each place, and with each code,
// in opencl_faults_long.
#include "codes.hpp"
#include "every_call.hpp"

#include <catch2/catch.hpp>

#include <set>

TEST_CASE("a run survives the failure of an OpenCL call from many places in the program, or says which one failed") {
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
            if (places.size() % (calls[nth].name == "clSetKernelArg" ? 96 : 24) != 0) continue;
            ++(test::check_failing_call(stage, nth, codes[turn++ % codes.size()]) ? struck : missed);
        }
    }

    CHECK(struck > 17);
    // How many calls come before a place hangs on the clock, too: batches are cut by time.
    CHECK(missed <= 2 + struck / 10);
    test::Faults::layer().reset();
}
