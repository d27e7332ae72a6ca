// The environment that ctest gives the tests: all of it must arrive.
#include <catch2/catch.hpp>

#include <cstdlib>
#include <string>

TEST_CASE("ctest gives tests every variable that is meant for them") {
    if (std::getenv("PELAGE_CACHE") == nullptr) return;  // started by hand
    const char* waiting = std::getenv("OMP_WAIT_POLICY");
    REQUIRE(waiting != nullptr);
    CHECK(std::string(waiting) == "passive");
    CHECK(std::getenv("LSAN_OPTIONS") != nullptr);
    CHECK(std::getenv("TSAN_OPTIONS") != nullptr);
    CHECK(std::getenv("PELAGE_POCL_HEADER") != nullptr);
}
