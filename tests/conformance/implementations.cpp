// See implementations.hpp.
#include "conformance/implementations.hpp"

#include <catch2/catch.hpp>

#include <filesystem>
#include <iostream>

namespace test {

namespace {

constexpr const char* oclgrind_driver = "/usr/lib/oclgrind/liboclgrind-rt-icd.so";

// A folder for the loader that names one driver, and stays until the test program ends.
std::string only(const std::string& driver) {
    static const Folder folder;
    folder.write("only.icd", driver + "\n");
    return folder.path().string();
}

}  // namespace

nlohmann::json Verification::result(const std::string& check) const {
    for (const auto& one : report["cases"]) {
        if (one["name"] == check) return one;
    }
    return {};
}

std::vector<std::string> Verification::of(const std::string& verdict) const {
    std::vector<std::string> names;
    for (const auto& one : report["cases"]) {
        if (one["verdict"] == verdict) names.push_back(one["name"]);
    }
    return names;
}

Verification verify(std::vector<std::string> words, const Surroundings& surroundings, const std::string& filter) {
    const Folder folder;
    words.insert(words.begin(), "verify");
    for (const std::string& word : {std::string("--json"), (folder / "report.json").string(), std::string("--evidence"),
                                    (folder / "evidence").string()}) {
        words.push_back(word);
    }
    if (!filter.empty()) words.insert(words.end(), {"--filter", filter});
    Verification verification{command(words, surroundings), {}};
    const std::string text = read_all(folder / "report.json");
    if (!text.empty()) verification.report = nlohmann::json::parse(text);
    return verification;
}

void require_equal_bits(const Verification& verification) {
    INFO(verification.told());
    REQUIRE(verification.report.is_object());
    const nlohmann::json& summary = verification.report["summary"];
    CHECK(summary["failed"] == 0);
    CHECK(summary["mistrusted"] == 0);
    CHECK(summary["cells_compared"] > 0);
    CHECK(summary["cells_differing"] == 0);
    CHECK(verification.process.exit_code == 0);
}

Surroundings on_rusticl() {
    Surroundings surroundings;
    surroundings.environment = {{"RUSTICL_ENABLE", "llvmpipe"}};
    return surroundings;
}

bool rusticl_missing() {
#ifdef __SANITIZE_THREAD__
    std::cout << "SKIPPED: under ThreadSanitizer llvmpipe takes longer than a test may\n";
    return true;
#endif
    if (command({"devices"}, on_rusticl()).out.find("llvmpipe") != std::string::npos) return false;
    std::cout << "SKIPPED: rusticl on llvmpipe (mesa-opencl-icd) is not there\n";
    return true;
}

Surroundings under_oclgrind() {
    Surroundings surroundings;
    surroundings.environment = {{"OCL_ICD_VENDORS", only(oclgrind_driver)},
                                {"OCLGRIND_DATA_RACES", "1"},
                                {"OCLGRIND_UNINITIALIZED", "1"},
                                {"OCLGRIND_MAX_ERRORS", "50"},
                                {"LD_PRELOAD", PELAGE_WHOLE_BUFFERS}};
    return surroundings;
}

bool oclgrind_missing() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    std::cout << "SKIPPED: Oclgrind is loaded with a library of the tests, and a sanitizer must be the first one\n";
    return true;
#endif
    if (std::filesystem::exists(oclgrind_driver)) return false;
    std::cout << "SKIPPED: Oclgrind (" << oclgrind_driver << ") is not there\n";
    return true;
}

}  // namespace test
