// Suggestions for misspelt words, colours by name, and the words of a line.
#include "language/words.hpp"
#include "language/cursor.hpp"
#include "language/statements.hpp"

#include <catch2/catch.hpp>

#include <vector>

using namespace pelage::language;

namespace {

const std::vector<pelage::Parameter> no_parameters;

}  // namespace

TEST_CASE("the nearest word is suggested, and none when none is near") {
    const std::string_view words[] = {"chemical", "time_step", "division_limit", "domain", "stencil"};

    CHECK(nearest("chemcial", words) == "chemical");
    CHECK(nearest("timestep", words) == "time_step");
    CHECK(nearest("STENCIL", words) == "stencil");
    CHECK(nearest("domian", words) == "domain");
    CHECK(nearest("banana", words).empty());
    CHECK(nearest("", words).empty());
    CHECK(nearest(std::string(5000, 'c'), words).empty());
    CHECK(suggestion("chem", {}).empty());
}

TEST_CASE("differences of case count less than other letters") {
    const std::string_view words[] = {"V", "u"};

    CHECK(nearest("U", words) == "u");
}

TEST_CASE("colours have CSS names in any case, or six hexadecimal digits") {
    CHECK(find_colour("white") == Colour{255, 255, 255});
    CHECK(find_colour("RebeccaPurple") == Colour{0x66, 0x33, 0x99});
    CHECK(find_colour("aliceblue") == Colour{0xf0, 0xf8, 0xff});
    CHECK(find_colour("yellowgreen") == Colour{0x9a, 0xcd, 0x32});
    CHECK(find_colour("lightgrey") == find_colour("lightgray"));
    CHECK(find_colour("DarkSlateGrey") == find_colour("darkslategray"));
    CHECK(find_colour("0080ff") == Colour{0x00, 0x80, 0xff});
    CHECK(find_colour("FFbf00") == Colour{0xff, 0xbf, 0x00});
    for (const char* text : {"", "fff", "0080fg", "-080ff", "+080ff", "0x80ff", "0080ff0", "blackk"}) {
        CHECK_FALSE(find_colour(text).has_value());
    }
}

TEST_CASE("numbers are decimal, finite and within float") {
    CHECK(to_number("+0.01") == 0.01);
    CHECK(to_number("-1.5e-3") == -0.0015);
    CHECK(to_number("007") == 7.0);
    for (const auto text :
         {"", "+", "-", "+-1", "++1", "1,5", "1.5f", "0x10", "inf", "nan", "1e39", "-1e39", "1e-400", " 1"}) {
        INFO(text);
        CHECK_FALSE(to_number(text).has_value());
    }
}

TEST_CASE("a line is split at blanks, quotes and comments") {
    Cursor cursor("t.pex:3", 3, " a\t\"b // c\"d\"\"//e", no_parameters);

    CHECK(cursor.peek().text == "a");
    CHECK(cursor.place(cursor.next()).column == 2);
    CHECK(cursor.peek().text == "b // c");
    CHECK(cursor.peek().quoted);
    CHECK(cursor.place(cursor.next()).column == 4);
    CHECK(cursor.next().text == "d");
    CHECK(cursor.peek().quoted);
    CHECK(cursor.next().text.empty());
    CHECK(cursor.done());
    CHECK(cursor.place(cursor.peek()).line == 3);
    CHECK(cursor.place(cursor.peek()).column == 15);
}

TEST_CASE("columns count characters, not bytes") {
    Cursor cursor("t.pex:1", 1, "\"\xc3\xa9\xe2\x82\xac\" next", no_parameters);

    cursor.next();

    CHECK(cursor.place(cursor.peek()).column == 6);
}
