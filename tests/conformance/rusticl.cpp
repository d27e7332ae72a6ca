// The same bits on Mesa's rusticl as on the reference; and what its loops do.
#include "conformance/implementations.hpp"

#include <catch2/catch.hpp>

using Catch::Contains;
using namespace test;

namespace {

void same_bits(const std::vector<std::string>& filters) {
    if (rusticl_missing()) return;
    for (const std::string& filter : filters) {
        const Verification verification = verify({"--device", "llvmpipe", "--quick"}, on_rusticl(), filter);

        require_equal_bits(verification);
        CHECK(verification.skipped().empty());
    }
}

}  // namespace

TEST_CASE("a device that ends loops silently is found out, with the number of turns") {
    if (rusticl_missing()) return;

    const Verification verification = verify({"--device", "llvmpipe"}, on_rusticl(), "device/long-loop");

    INFO(verification.told());
    const nlohmann::json result = verification.result("device/long-loop");
    REQUIRE(result.is_object());
    CHECK(result["verdict"] == "skipped");
    CHECK_THAT(result["message"].get<std::string>(), Contains("65535 turns"));
    CHECK_THAT(verification.process.out, Contains("65535 turns"));
}

TEST_CASE("rusticl gives the reference's bits: random numbers, scan, neighbour search") {
    same_bits({"random/", "scan/", "neighbours/special"});
}

TEST_CASE("rusticl gives the reference's bits: lattices that grow, fused and not, and checkpoints") {
    same_bits({"growth/", "checkpoint/"});
}

TEST_CASE("rusticl gives the reference's bits: uneven rates, polarity, rules in chains") {
    same_bits({"rates/uneven/published", "rates/polarized/five-point", "rules/chains", "laws/m"});
}

TEST_CASE("rusticl gives the reference's bits: subnormal numbers, which are 0") {
    same_bits({"device/subnormal", "values/denormal/published", "near-zero"});
}

TEST_CASE("rusticl gives the reference's bits: free cells that divide and turn") {
    same_bits({"cells/at-one-place", "cells/spatial-sorting", "not-finite"});
}
