// Numbers nearer to 0 than 2^-126 are 0 in single precision, and only there; the processor's mode is given back.
#include "core/subnormal.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <thread>

using namespace pelage;

namespace {

volatile float small = 0x1p-100f;
volatile float smaller = 0x1p-40f;
volatile float subnormal = 0x1p-130f;
volatile float large = 0x1p40f;

bool results_are_zero() { return small * smaller == 0.0f; }
bool operands_are_zero() { return subnormal * large == 0.0f; }

}  // namespace

TEST_CASE("a number that enters single precision is 0 below 2^-126, with its sign") {
    CHECK(in_precision<float>(0x1p-126) == 0x1p-126f);
    CHECK(in_precision<float>(-0x1p-126) == -0x1p-126f);
    CHECK(in_precision<float>(0x1.ffffffffp-127) == 0.0f);
    CHECK_FALSE(std::signbit(in_precision<float>(1e-45)));
    CHECK(in_precision<float>(-1e-45) == 0.0f);
    CHECK(std::signbit(in_precision<float>(-1e-45)));
    CHECK(std::signbit(in_precision<float>(-0.0)));
    CHECK(in_precision<float>(0.1) == 0.1f);
    CHECK(std::isnan(in_precision<float>(std::numeric_limits<double>::quiet_NaN())));
    CHECK(in_precision<float>(-std::numeric_limits<double>::infinity()) == -std::numeric_limits<float>::infinity());
}

TEST_CASE("double precision keeps what it is given") {
    CHECK(in_precision<double>(1e-45) == 1e-45);
    CHECK(in_precision<double>(-5e-324) == -5e-324);
}

TEST_CASE("subnormal numbers are 0 while the scope lasts, and no longer") {
    if (!processor_flushes()) {
        WARN("this processor cannot take subnormal numbers for 0");
        return;
    }
    REQUIRE_FALSE(results_are_zero());
    {
        const SubnormalsAreZero scope;
        CHECK(results_are_zero());
        CHECK(operands_are_zero());
        {
            const SubnormalsAreZero inner;
            CHECK(results_are_zero());
        }
        CHECK(results_are_zero());
        CHECK(operands_are_zero());
    }
    CHECK_FALSE(results_are_zero());
    CHECK_FALSE(operands_are_zero());
}

TEST_CASE("the mode is given back when an error is thrown, and is that of one thread") {
    try {
        const SubnormalsAreZero scope;
        throw std::runtime_error("");
    } catch (const std::runtime_error&) {
        CHECK_FALSE(results_are_zero());
    }
    std::thread([] { const SubnormalsAreZero scope; }).join();
    CHECK_FALSE(results_are_zero());
}

TEST_CASE("a scope that is not wanted changes nothing") {
    const SubnormalsAreZero scope(false);
    CHECK_FALSE(results_are_zero());
    CHECK_FALSE(operands_are_zero());
}
