// What the numbers of a training may be: said alike by the help, the page of the command and the messages.
#include "core/learning.hpp"
#include "learn/settings.hpp"
#include "training.hpp"

#include <catch2/catch.hpp>

#include <cstdint>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

using namespace pelage;
using Catch::Contains;
using test::command;

namespace {

// Without line breaks and the blanks after them.
std::string in_one_line(const std::string& text) {
    std::istringstream words(text);
    std::string line;
    for (std::string word; words >> word;) line += (line.empty() ? "" : " ") + word;
    return line;
}

std::string page() {
    const std::string text = test::read_all(std::filesystem::path(PELAGE_SOURCE) / "docs" / "command.md");
    const auto begin = text.find("## Textures learned from a picture");
    REQUIRE(begin != std::string::npos);
    return text.substr(begin, text.find("\n## ", begin + 3) - begin);
}

// What the help says of an option.
std::string entry(const std::string& option) {
    static const std::string text = command({"learn", "--help"}).out;
    const auto begin = text.find("\n  " + option + " ");
    REQUIRE(begin != std::string::npos);
    return in_one_line(text.substr(begin, text.find("\n  -", begin + 1) - begin));
}

template <class Limit>
void check_told(const Limit& limit) {
    INFO(limit.option);
    CHECK_THAT(entry(limit.option), Contains(allowed(limit)));
    const std::string text = page();
    const auto begin = text.find("`" + std::string(limit.option) + " ");
    REQUIRE(begin != std::string::npos);
    CHECK_THAT(text.substr(begin, text.find('\n', begin) - begin), Contains(allowed(limit)));
}

}  // namespace

TEST_CASE("limits are told by the help and by the page as the messages tell them") {
    CHECK(allowed(learning_limits::size) == "a multiple of 16 from 32 to 512");
    for (const WholeLimit& limit :
         {learning_limits::size, learning_limits::batch, learning_limits::chemicals, learning_limits::hidden,
          learning_limits::rotations, learn::limits::steps, learn::limits::pool, learn::limits::seed_every,
          learn::limits::iterations, learn::limits::memory})
        check_told(limit);
    for (const learn::RealLimit& limit :
         {learn::limits::scale, learn::limits::rate, learn::limits::drop, learn::limits::overflow})
        check_told(limit);
}

TEST_CASE("a number just beyond its limit is refused with the limit, by the command as by the library") {
    const test::Folder folder;
    test::write_spots(folder / "spots.png");
    const auto refused = [&](const std::string& option, const std::string& value) {
        const test::Outcome outcome = command({"learn", folder / "spots.png", option, value});
        INFO(option << " " << value << ": " << outcome.err);
        CHECK(outcome.exit_code == 2);
        CHECK(outcome.err.starts_with("pelage: " + option));
        return outcome.err;
    };
    for (const WholeLimit& limit : {learning_limits::size, learning_limits::batch, learning_limits::chemicals,
                                    learning_limits::hidden, learning_limits::rotations}) {
        for (const std::uint64_t value : {limit.least - 1, limit.most + 1, limit.most + limit.multiple}) {
            CHECK_FALSE(limit.allows(value));
            CHECK_THAT(refused(limit.option, std::to_string(value)), Contains("is not " + allowed(limit)));
            CHECK_THROWS_WITH(check_limit(limit, value), Contains("allowed is " + allowed(limit)));
        }
        CHECK(limit.allows(limit.least));
        CHECK(limit.allows(limit.most));
    }
    for (const char* value : {"0", "0.01", "1e-9", "1001", "nan", "inf", "-1"})
        CHECK_THAT(refused("--scale", value), Contains("is not a number from 0.1 to 1000"));
    for (const char* value : {"0", "1e-50", "1e300", "-0.1"}) (void)refused("--rate", value);
    for (const char* value : {"0", "1e-50", "1e9"}) (void)refused("--drop", value);
    for (const char* value : {"-1", "1e300"}) (void)refused("--overflow", value);
    CHECK_THAT(refused("--drop-at", "0"), Contains("'0' is not a whole number from 1 to"));
    CHECK_THAT(refused("--drop-at", "3,"), Contains("'' is not a whole number"));
    CHECK_THAT(refused("--drop-at", ""), Contains("--drop-at"));
    for (const char* value : {"3,3", "5,3"}) CHECK_THAT(refused("--drop-at", value), Contains("3 does not"));
    for (const char* value : {"8:12:13", "8", "8-12"})
        CHECK_THAT(refused("--iterations", value), Contains("is written LOW:HIGH, two numbers as in 32:96"));
    CHECK_THAT(refused("--iterations", "0:9"), Contains("'0' is not a whole number from 1 to 10000"));
    CHECK_THAT(refused("--iterations", "9:10001"), Contains("'10001' is not"));
    CHECK_THAT(refused("--iterations", "9:8"), Contains("the first number is at most the second"));
}

TEST_CASE("what no single number shows is refused, too") {
    const test::Folder folder;
    test::write_spots(folder / "spots.png");
    const auto refused = [&](std::vector<std::string> more) {
        more.insert(more.begin(), {"learn", folder / "spots.png"});
        const test::Outcome outcome = command(more);
        CHECK(outcome.exit_code == 2);
        return outcome.err;
    };
    CHECK_THAT(refused({"--backend", "reference", "--device", "0"}),
               Contains("--device chooses an OpenCL device; it goes with --backend opencl"));
    CHECK_THAT(refused({"--drop", "1e-6", "--drop-at", "1,2,3,4,5,6"}), Contains("single precision holds"));
    CHECK_THAT(refused({"--scale", "5", "--wrap"}), Contains("is 6.4 cells wide or high; 7 are the least"));
    CHECK_THAT(refused({"--size", "512", "--pool", "4", "--memory", "64"}), Contains("comes to 0.0625 pixels a cell"));
    CHECK(test::names_in(folder.path()) == std::vector<std::string>{"spots.png"});
    // As people write them.
    CHECK(command(test::training_words(
                      folder, "a.npz",
                      {"--steps", "2", "--drop-at", "1e3, 2e3", "--backend", "reference", "--rate", "+1e-3"}))
              .exit_code == 0);
}
