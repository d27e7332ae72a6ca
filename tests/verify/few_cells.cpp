// Cases of few cells prove something where they end neither flat nor as they began.
#include "opencl/device/device.hpp"
#include "verify/check.hpp"

#include <catch2/catch.hpp>

#include <set>
#include <string>

using namespace pelage;

TEST_CASE("a case whose only size has few cells passes on every path, and is not left out") {
    verify::Place place(select_device(), 1, false, false);
    std::set<std::string> found;
    for (const verify::Check& check : verify::all_checks(1)) {
        if (!check.name.ends_with("neural/texture")) continue;
        INFO(check.name);
        found.insert(check.name);
        const verify::Outcome outcome = check.run(place);
        CHECK(outcome.verdict == verify::Verdict::passed);
        CHECK(outcome.message.empty());
        CHECK(outcome.tally.cells_compared > 0);
    }
    CHECK(found == std::set<std::string>{"neural/texture", "streamed/neural/texture", "tiled/neural/texture",
                                         "shared/neural/texture", "batch/neural/texture"});
}
