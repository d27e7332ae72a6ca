// Cases of volumes leave room for waves: a wave ends where other rules act.
#include "core/schedule.hpp"
#include "verify/cases.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cstdint>

using namespace pelage;
using namespace pelage::verify;

TEST_CASE("in every case of a volume the same rules act for five iterations and more") {
    std::size_t cases = 0;
    for (const Case& one : lattice_cases()) {
        if (!one.name.starts_with("volume/")) continue;
        INFO(one.name);
        ++cases;
        const Experiment experiment = one.experiment({7, 6, 5});
        std::uint64_t longest = 0;
        for (std::uint64_t from = 0; from < one.iterations;) {
            const std::uint64_t to = std::min(next_change(experiment, from), one.iterations);
            longest = std::max(longest, to - from);
            from = to;
        }
        CHECK(longest >= 5);
    }
    CHECK(cases > 10);
}
