// What the library keeps for the whole process is never destroyed: a session that lives until the process has ended
// still stores what was compiled, and would come to tables and sets that are gone.
#include "house/source.hpp"
#include "support/process.hpp"

#include <catch2/catch.hpp>

#include <filesystem>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

using test::read_all;

namespace {

// Variables that live in a function or a namespace and have something to destroy, as "line: text".
std::vector<std::string> destroyed_at_the_end(const std::string& text) {
    const std::regex in_function(
        "^ +static (const )?(?!const |constexpr|cl_|void |bool |int |double |std::size_t |std::mutex |"
        "std::once_flag |std::atomic<)[^(]* [a-z_]+( = .*|\\{.*|;)$");
    const std::regex in_namespace(
        "^(const |static |inline )*std::(map|set|multimap|vector|string|filesystem::path|"
        "unique_ptr|shared_ptr|function)\\b[^(]* [a-z_]+( = .*|\\{.*|;)$");
    std::vector<std::string> found;
    std::istringstream lines(text);
    std::size_t number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        if (!std::regex_match(line, in_function) && !std::regex_match(line, in_namespace)) continue;
        const bool lasts = line.find("& ") < line.find(" = ") && line.find(" = ") != std::string::npos;
        if (!lasts) found.push_back(std::to_string(number) + ": " + line);
    }
    return found;
}

}  // namespace

TEST_CASE("a variable that is destroyed when the process ends is recognised") {
    CHECK(destroyed_at_the_end("    static const std::map<int, int> table{\n").size() == 1);
    CHECK(destroyed_at_the_end("    static std::set<fs::path> tidied;\n").size() == 1);
    CHECK(destroyed_at_the_end("const std::vector<int> numbers{1, 2};\n").size() == 1);
    CHECK(destroyed_at_the_end("    static const auto& table = *new const std::map<int, int>{\n").empty());
    CHECK(destroyed_at_the_end("    static std::mutex guard;\n").empty());
    CHECK(destroyed_at_the_end("    static const std::size_t known = [] {\n").empty());
    CHECK(destroyed_at_the_end("    static std::string text(int number);\n").empty());
}

TEST_CASE("the library destroys nothing when the process ends, but for PoCL's folder") {
    for (const char* part : {"host/core", "host/io", "host/language", "host/opencl", "reference", "cmake"}) {
        for (const auto& entry : std::filesystem::recursive_directory_iterator(source / part)) {
            if (!entry.is_regular_file()) continue;
            std::vector<std::string> found = destroyed_at_the_end(read_all(entry.path()));
            // It is made before the first session can be, and thus goes after the last one.
            std::erase_if(found, [](const std::string& line) {
                return line.find("static Preparation known;") != std::string::npos;
            });
            INFO(entry.path().string());
            CHECK(found == std::vector<std::string>{});
        }
    }
}
