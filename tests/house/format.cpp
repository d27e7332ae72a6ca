// The sources are as clang-format writes them. Other versions of it write otherwise.
#include "house/source.hpp"
#include "support/process.hpp"

#include <catch2/catch.hpp>

#include <chrono>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

bool formatter_missing() {
    if (test::shell("command -v clang-format-14").exit_code == 0) return false;
    std::cout << "SKIPPED: clang-format-14 is not there\n";
    return true;
}

test::Outcome checked(const std::vector<std::string>& files) {
    std::vector<std::string> words{"clang-format-14", "--dry-run", "-Werror"};
    words.insert(words.end(), files.begin(), files.end());
    test::Surroundings surroundings;
    surroundings.patience = std::chrono::minutes(10);
    return test::Child(words, surroundings).wait();
}

std::vector<std::string> all_sources() {
    std::vector<std::string> files;
    for (const char* part : {"host", "reference", "tests", "bench", "examples"}) {
        for (const auto& entry : fs::recursive_directory_iterator(source / part)) {
            if (entry.path().extension() == ".cpp" || entry.path().extension() == ".hpp")
                files.push_back(entry.path().string());
        }
    }
    return files;
}

}  // namespace

TEST_CASE("the sources are in the house's format") {
    if (formatter_missing()) return;
    const std::vector<std::string> files = all_sources();
    REQUIRE(files.size() > 500);

    const test::Outcome outcome = checked(files);

    INFO(outcome.out << outcome.err);
    CHECK(outcome.exit_code == 0);
}

TEST_CASE("a source that is not in the house's format is seen") {
    if (formatter_missing()) return;
    const test::Folder folder;
    folder.write(".clang-format", test::read_all(source / ".clang-format"));

    CHECK(checked({folder.write("good.cpp", "int main() { return 0; }\n")}).exit_code == 0);
    const test::Outcome bad = checked({folder.write("bad.cpp", "int main( ) { return 0; }\n")});
    CHECK(bad.exit_code != 0);
    CHECK_THAT(bad.err, Catch::Contains("bad.cpp:1:10: error: code should be clang-formatted"));
}
