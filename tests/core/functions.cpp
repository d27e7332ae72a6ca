// The table of elementary functions.
#include "core/functions.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <string>

using namespace pelage;

TEST_CASE("functions stand by the alphabet and are found by name") {
    const auto& table = function_table();
    REQUIRE(table.size() >= 13);
    CHECK(std::ranges::is_sorted(table, {}, &FunctionFacts::name));
    for (std::size_t index = 0; index < table.size(); ++index) {
        INFO(table[index].name);
        CHECK(function_named(table[index].name) == index);
        CHECK(table[index].parameters.size() >= 1);
        CHECK(table[index].parameters.size() <= 3);
    }
    CHECK_FALSE(function_named("numbers"));  // a part
    CHECK_FALSE(function_named(""));
    CHECK(table[*function_named("mix")].parameters == std::vector<std::string>{"a", "b", "t"});
}

TEST_CASE("parts are no functions and have no parameters") {
    REQUIRE(part_table().size() >= 2);
    for (const FunctionFacts& part : part_table()) {
        CHECK(part.parameters.empty());
        CHECK_FALSE(function_named(part.name));
    }
}
