// Every model of a reaction stands in every place where models are listed, and CONTRIBUTING.md names these places.
#include "app/process.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <string>
#include <vector>

using test::read_all;

namespace {

const std::filesystem::path source = PELAGE_SOURCE;

// As the enumeration in core/experiment.hpp has them: "gray_scott".
std::vector<std::string> models() {
    const std::string text = read_all(source / "host/core/experiment.hpp");
    std::smatch list;
    REQUIRE(std::regex_search(text, list, std::regex("enum class Model \\{([^}]*)\\}")));
    const std::string inside = list[1].str();
    std::vector<std::string> names;
    const std::regex word("[a-z0-9_]+");
    for (auto at = std::sregex_iterator(inside.begin(), inside.end(), word); at != std::sregex_iterator(); ++at)
        names.push_back(at->str());
    return names;
}

// As the language has it: "gray-scott".
std::string spoken(std::string model) {
    std::ranges::replace(model, '_', '-');
    return model;
}

// Files that hold the name of each model in C++, and files that hold its word.
const std::vector<std::string> with_names{"host/core/experiment.cpp",     "host/language/action.cpp",
                                          "reference/reactions.cpp",      "host/verify/cases.cpp",
                                          "host/verify/random_rules.cpp", "tests/reference/reactions.cpp"};
const std::vector<std::string> with_words{"host/verify/cases_cells.cpp",
                                          "tests/language/action_test.cpp",
                                          "tests/language/rule_errors_test.cpp",
                                          "tests/random_experiments/texts.cpp",
                                          "tests/fuzz/pex.dict",
                                          "tests/fuzz/corpus/reactions.pex",
                                          "docs/language.md"};

}  // namespace

TEST_CASE("every model has its two files and stands in every list") {
    const std::vector<std::string> all = models();
    REQUIRE(all.size() >= 6);

    for (const std::string& model : all) {
        INFO(model);
        CHECK(std::filesystem::exists(source / ("reference/models/" + model + ".hpp")));
        CHECK(std::filesystem::exists(source / ("kernels/models/" + model + ".cl")));
        for (const std::string& file : with_names) {
            INFO(file);
            CHECK(std::regex_search(read_all(source / file), std::regex("Model::" + model + "\\b")));
        }
        for (const std::string& file : with_words) {
            INFO(file);
            CHECK(std::regex_search(read_all(source / file), std::regex("\\b" + spoken(model) + "\\b")));
        }
    }
}

TEST_CASE("CONTRIBUTING.md names every place that a new reaction must be told to") {
    const std::string text = read_all(source / "CONTRIBUTING.md");

    for (const std::vector<std::string>* files : {&with_names, &with_words}) {
        for (const std::string& file : *files) CHECK_THAT(text, Catch::Contains("`" + file + "`"));
    }
    for (const char* file : {"host/core/experiment.hpp", "host/opencl/emit_rules.cpp"})
        CHECK_THAT(text, Catch::Contains(std::string("`") + file + "`"));
}
