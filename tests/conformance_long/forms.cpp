// The whole quick form on the device that a run would take, on rusticl and, in its smallest sizes, under Oclgrind.
#include "conformance/implementations.hpp"

#include <catch2/catch.hpp>

#include <chrono>

using namespace test;
using Names = std::vector<std::string>;

namespace {

constexpr std::chrono::minutes patience{30};

}  // namespace

TEST_CASE("the usual device gives the reference's bits in the whole quick form") {
    Surroundings surroundings;
    surroundings.patience = patience;

    const Verification verification = verify({"--quick"}, surroundings);

    require_equal_bits(verification);
}

TEST_CASE("rusticl gives the reference's bits in the whole quick form") {
    if (rusticl_missing()) return;
    Surroundings surroundings = on_rusticl();
    surroundings.patience = patience;

    const Verification verification = verify({"--device", "llvmpipe", "--quick"}, surroundings);

    require_equal_bits(verification);
    for (const std::string& name : verification.skipped()) {
        const std::string message = verification.result(name)["message"];
        CHECK((name == "device/long-loop" || message == "the device has no numbers of double precision"));
    }
}

// Oclgrind takes a truth that fills a vector for 1 where all bits should be set. Compilers make one of a comparison of
// what all lanes share; a generated world has such a one, `Y < -3.25`, in vectors of eight.
TEST_CASE(
    "Oclgrind finds nothing in the whole quick form, and but for one comparison of its own the reference's bits") {
    if (oclgrind_missing()) return;
    Surroundings surroundings = under_oclgrind();
    surroundings.patience = patience;

    const Verification verification = verify({"--small", "--jobs", "2"}, surroundings);

    INFO(verification.told());
    REQUIRE(verification.report.is_object());
    CHECK(verification.process.err.empty());
    CHECK(verification.of("failed") == Names{"pairs/lattice/5-tiled-five-point-no-flux"});
    CHECK(verification.of("mistrusted").empty());
    CHECK(verification.skipped() == Names{"device/subnormal", "neighbours/many", "values/denormal/published",
                                          "sizes/many-rows", "cells/near-zero", "cells/many", "learning/one-rotation"});
}
