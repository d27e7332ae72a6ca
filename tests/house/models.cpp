// A reaction is two files, and nowhere else in the sources are the reactions listed.
#include "core/models.hpp"
#include "house/source.hpp"
#include "support/process.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <string>
#include <vector>

using namespace pelage;
using test::read_all;

namespace {

// "gray_scott"
std::string file_of(std::string word) {
    std::ranges::replace(word, '-', '_');
    return word;
}

// How many reactions a text names, by their words or the names of their files.
std::size_t named_in(const std::string& text) {
    return static_cast<std::size_t>(std::ranges::count_if(model_table(), [&](const ModelFacts& model) {
        return std::regex_search(text, std::regex("\\b(" + model.word + "|" + file_of(model.word) + ")\\b"));
    }));
}

// Text and code that may name every reaction: their formulas worked by hand, and what draws the same for ever.
const std::vector<std::filesystem::path> may_list{"tests/reference/reactions.cpp", "tests/random_experiments/texts.cpp",
                                                  "tests/opencl/formulas.cpp", "host/bench/formula_cases.cpp",
                                                  "tests/fuzz/corpus/reactions.pex"};

}  // namespace

TEST_CASE("every reaction has its two files") {
    REQUIRE(model_table().size() >= 6);
    for (const ModelFacts& model : model_table()) {
        INFO(model.word);
        CHECK(std::filesystem::exists(source / ("reference/models/" + file_of(model.word) + ".hpp")));
        CHECK(std::filesystem::exists(source / ("kernels/models/" + file_of(model.word) + ".cl")));
    }
}

TEST_CASE("a list of the reactions is recognised") {
    CHECK(named_in("turing gray-scott linear gm1 cubic reinforcement") >= 6);
    CHECK(named_in("case Model::gray_scott: case Model::turing:") == 2);
    CHECK(named_in("bilinear, bicubic") == 0);
}

TEST_CASE("no other file lists the reactions: it would have to be edited for a new one") {
    for (const char* part : {"host", "kernels", "reference", "cmake", "tests"}) {
        for (const auto& entry : std::filesystem::recursive_directory_iterator(source / part)) {
            const auto path = entry.path().lexically_relative(source);
            if (!entry.is_regular_file() || std::ranges::find(may_list, path) != may_list.end()) continue;
            if (path == "tests/house/models.cpp") continue;
            INFO(path.string());
            CHECK(named_in(read_all(entry.path())) < 5);
        }
    }
}

TEST_CASE("CONTRIBUTING.md tells of the two files and of the row in the language's page") {
    const std::string text = read_all(source / "CONTRIBUTING.md");
    for (const char* file : {"reference/models/x_y.hpp", "kernels/models/x_y.cl", "docs/language.md"})
        CHECK_THAT(text, Catch::Contains(std::string("`") + file + "`"));
}
