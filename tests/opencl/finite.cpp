// What is not finite is told by bits everywhere: built-in questions may be answered without a look by fast arithmetic.
#include "opencl/device/kernel_sources.hpp"

#include <catch2/catch.hpp>

TEST_CASE("no kernel asks isfinite, isnan, isinf or isnormal") {
    CHECK(pelage::kernel_sources().size() > 20);
    for (const auto& [name, text] : pelage::kernel_sources()) {
        INFO(name);
        for (const char* question : {"isfinite", "isnan", "isinf", "isnormal"}) {
            CHECK(text.find(question) == std::string::npos);
        }
    }
}
