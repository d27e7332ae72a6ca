// No file includes itself by way of others. See circle.hpp.
#include "house/circle.hpp"

#include "house/source.hpp"
#include "support/process.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <regex>

namespace test {

std::vector<std::string> circle(const Includes& all, const std::string& one) {
    std::map<std::string, std::string> from;
    std::vector<std::string> open{one};
    while (!open.empty()) {
        const std::string here = open.back();
        open.pop_back();
        const auto found = all.find(here);
        if (found == all.end()) continue;
        for (const std::string& next : found->second) {
            if (!from.emplace(next, here).second) continue;
            if (next == one) {
                std::vector<std::string> way{one};
                for (std::string at = from.at(one); at != one; at = from.at(at)) way.push_back(at);
                return way;
            }
            open.push_back(next);
        }
    }
    return {};
}

}  // namespace test

namespace {

// The file that `name` stands for in an #include of `file`; empty for what is not ours.
std::string included(const std::filesystem::path& file, const std::string& name) {
    for (const auto& folder : {file.parent_path(), source / "host", source, source / "tests"}) {
        const auto there = (folder / name).lexically_normal();
        if (std::filesystem::is_regular_file(there)) return there.lexically_relative(source).string();
    }
    return "";
}

test::Includes includes_of_files() {
    test::Includes found;
    const std::regex line("(^|\n) *#include \"([^\"]+)\"");
    for (const char* part : {"host", "reference", "tests", "examples"}) {
        for (const auto& entry : std::filesystem::recursive_directory_iterator(source / part)) {
            if (entry.path().extension() != ".cpp" && entry.path().extension() != ".hpp") continue;
            const std::string text = test::read_all(entry.path());
            std::set<std::string>& others = found[entry.path().lexically_relative(source).string()];
            for (auto at = std::sregex_iterator(text.begin(), text.end(), line); at != std::sregex_iterator(); ++at) {
                const std::string other = included(entry.path(), (*at)[2].str());
                if (!other.empty()) others.insert(other);
            }
        }
    }
    return found;
}

}  // namespace

TEST_CASE("a circle of includes is recognised") {
    CHECK(test::circle({{"a", {"b"}}, {"b", {"c"}}, {"c", {"b"}}}, "b").size() == 2);
    CHECK(test::circle({{"a", {"b"}}, {"b", {"c"}}, {"c", {"b"}}}, "a").empty());
    CHECK(test::circle({{"a", {"a"}}}, "a") == std::vector<std::string>{"a"});
}

TEST_CASE("no file includes itself by way of others") {
    const test::Includes all = includes_of_files();
    REQUIRE(all.size() > 500);
    REQUIRE(all.at("host/opencl/device/program.cpp").contains("host/opencl/device/program.hpp"));

    for (const auto& [file, unused] : all) {
        const std::vector<std::string> way = test::circle(all, file);
        INFO(file);
        CHECK(way == std::vector<std::string>{});
    }
}
