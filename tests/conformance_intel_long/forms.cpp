// Intel's runtime for CPUs, where it is installed: PELAGE_INTEL_ICD names the folder of the .icd file that names it.
#include "conformance/implementations.hpp"

#include <catch2/catch.hpp>

#include <cstdlib>
#include <iostream>
#include <optional>

using namespace test;

namespace {

// Surroundings in which its device is the only one; empty, after saying why, when there is none.
std::optional<Surroundings> on_intel() {
    const char* folder = std::getenv("PELAGE_INTEL_ICD");
    if (folder == nullptr || *folder == '\0') {
        std::cout << "SKIPPED: PELAGE_INTEL_ICD does not name a folder with Intel's .icd file\n";
        return {};
    }
    Surroundings surroundings;
    surroundings.environment = {{"OCL_ICD_VENDORS", folder}};
    surroundings.patience = std::chrono::minutes(60);
    return surroundings;
}

void same_bits(const std::string& form) {
    const auto surroundings = on_intel();
    if (!surroundings) return;

    const Verification verification = verify({form}, *surroundings);

    require_equal_bits(verification);
    CHECK(verification.report["platform"] == "Intel(R) OpenCL");
    CHECK(verification.skipped().empty());
}

}  // namespace

TEST_CASE("Intel's runtime gives the reference's bits in the quick form") { same_bits("--quick"); }

TEST_CASE("Intel's runtime gives the reference's bits in the full form") { same_bits("--full"); }
