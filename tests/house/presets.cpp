// CMakePresets.json against what is said of it: every preset can be configured, built and tested by its one name.
#include "house/source.hpp"
#include "support/process.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <regex>
#include <set>
#include <string>

using test::read_all;

namespace {

std::set<std::string> presets(const char* kind) {
    std::set<std::string> names;
    const auto all = nlohmann::json::parse(read_all(source / "CMakePresets.json"));
    for (const auto& preset : all.at(kind)) {
        if (!preset.value("hidden", false)) names.insert(preset.at("name").get<std::string>());
    }
    return names;
}

}  // namespace

TEST_CASE("every preset serves cmake, cmake --build and ctest") {
    const std::set<std::string> configured = presets("configurePresets");

    CHECK(configured.count("debug") + configured.count("fuzz") == 2);
    CHECK(presets("buildPresets") == configured);
    CHECK(presets("testPresets") == configured);
}

TEST_CASE("every preset that a page names is there, and CONTRIBUTING.md names them all") {
    const std::set<std::string> names = presets("configurePresets");
    const std::regex use("--preset ([a-z]+)");
    std::vector<std::filesystem::path> pages{source / "README.md", source / "CONTRIBUTING.md"};
    for (const auto& entry : std::filesystem::directory_iterator(source / "docs")) {
        if (entry.path().extension() == ".md") pages.push_back(entry.path());
    }

    for (const std::filesystem::path& page : pages) {
        const std::string text = read_all(page);
        for (auto found = std::sregex_iterator(text.begin(), text.end(), use); found != std::sregex_iterator();
             ++found) {
            INFO(page << ": " << found->str());
            CHECK(names.count((*found)[1].str()) == 1);
        }
    }
    const std::string contributing = read_all(source / "CONTRIBUTING.md");
    for (const std::string& name : names) CHECK_THAT(contributing, Catch::Contains("`" + name + "`"));
}
