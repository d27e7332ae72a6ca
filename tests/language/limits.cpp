// Sizes: what is too large is refused at once, and what is large but allowed is read in one pass.
#include "language/error_case.hpp"
#include "language/parse.hpp"
#include "language/parsed.hpp"

#include <catch2/catch.hpp>

#include <fmt/format.h>

#include <chrono>

using namespace test;

namespace {

std::string repeated(std::size_t times, const std::string& line) {
    std::string text;
    text.reserve(times * line.size());
    for (std::size_t i = 0; i < times; ++i) text += line;
    return text;
}

std::string chemicals(std::size_t count) {
    std::string text;
    for (std::size_t i = 0; i < count; ++i) text += fmt::format("define chemical C{}\n", i);
    return text + "create cell 0 0\n";
}

std::string mappings(std::size_t count) {
    std::string text;
    for (std::size_t i = 0; i < count; ++i) text += fmt::format("rule always map AGE 0 1 to M{} 0 1\n", i);
    return text;
}

double seconds_to_parse(const std::string& text) {
    const auto start = std::chrono::steady_clock::now();
    message_of(text);
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

TEST_CASE("64 chemicals and 64 mappings are allowed, 65 are not") {
    CHECK(parsed(chemicals(64)).chemicals.size() == 64);
    CHECK(message_of(chemicals(65)) == "t.pex:65:17: one chemical too many; at most 64 are allowed");
    CHECK(parsed_on_grid(mappings(64)).mappings.size() == 64);
    CHECK(message_of(grid + mappings(65)) == "t.pex:68:28: one mapping too many; at most 64 are allowed");
}

TEST_CASE("phases, lines and texts have a largest size") {
    const std::string phases = repeated(pelage::largest_phase_count, "phase \"p\" 1\n");
    const std::string line = "//" + std::string(pelage::largest_line - 2, '.');
    const std::string text = grid + repeated(pelage::largest_text / 1024, std::string(1023, ' ') + "\n");

    CHECK(parsed_on_grid(phases).phases.size() == pelage::largest_phase_count);
    CHECK(message_of(grid + phases + "phase \"p\" 1\n") ==
          "t.pex:10004:7: one phase too many; at most 10000 are allowed");
    CHECK(message_of(grid + line) == "(none)");
    CHECK(message_of(grid + line + ".") == "t.pex:4:1: the line has 1048577 bytes; at most 1048576 are allowed");
    CHECK(message_of(text) == "t.pex: is longer than the 16777216 bytes allowed");
}

TEST_CASE("names have at most 32 characters, and messages quote no more than 40") {
    const std::string name(32, 'a');

    CHECK(parsed_on_grid("define chemical " + name).chemicals.at(2).name == name);
    CHECK(message_of(grid + "define chemical " + name + "a") ==
          "t.pex:4:17: '" + name +
              "a' cannot name a chemical; names are a letter, then up to 31 letters, digits, _ or -");
    CHECK(message_of(grid + "stop at " + std::string(100, '9')) ==
          "t.pex:4:9: '" + std::string(40, '9') +
              "...' is out of range; the last iteration must be a whole number from 0 to 4294967295");
}

TEST_CASE("as many cells as can be addressed are counted, not created") {
    CHECK(message_of("define chemical U\ncreate matrix 2147483647 1\n") == "(none)");
    CHECK(message_of("define chemical U\ncreate sqr_grid 1 2147483647\n") == "(none)");
    CHECK(seconds_to_parse("define chemical U\ncreate hex_circle 48000\ncreate cell 0 0\n") < 5.0);
    CHECK(seconds_to_parse("define chemical U\ncreate sqr_circle 52000\ncreate cell 0 0\n") < 5.0);
}

TEST_CASE("a growing matrix is measured at the end of its run") {
    const std::string text = matrix + "rule every 10 offset 5 always expand columns 1000 rows 1000\n";

    CHECK(message_of(text + "stop at 465\n") == "(none)");  // 46 expansions: 46020 x 46010
    CHECK(message_of(text + "stop at 466\n") ==
          "t.pex:4:31: the matrix grows to 47020 x 47010 elements; at most 2147483647 cells are allowed");
    CHECK(message_of(text + "snap at 465 then exit\n") == "(none)");
}

TEST_CASE("long experiments take a time that grows with their length only") {
    const std::pair<const char*, std::string> all[] = {
        {"rules", repeated(100000, "rule if U conc > 1 change V conc +1\n")},
        {"cells", repeated(100000, "set cell 7 chemical U conc 1 polarity none fixed\n")},
        {"grids", repeated(100000, "create hex_circle 3\n")},
        {"words", repeated(10, repeated(100000, "snap ") + "\n")},
        {"quotes", "output U colormap" + repeated(50000, " \"red at 0, red at 0\"")},
        {"snapshots", "snap at" + repeated(150000, " 5") + "\n"},
        {"blank lines", repeated(2000000, "\n")},
        {"comments", repeated(500000, "//  \"\n")},
    };
    for (const auto& [what, text] : all) {
        INFO(what);
        CHECK(seconds_to_parse(grid + text) < 30.0);
    }
}
