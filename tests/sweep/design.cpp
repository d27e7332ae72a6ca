// Which tiles a sweep has.
#include "sweep/design.hpp"
#include "core/error.hpp"
#include "support/process.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

using namespace pelage;
using namespace pelage::sweep;
using Catch::Contains;

namespace {

using Words = std::vector<std::string>;

double value(const Point& point, std::size_t axis) { return std::stod(point.settings.at(axis).value); }

}  // namespace

TEST_CASE("values of an axis: listed, evenly and logarithmically spaced") {
    CHECK(parse_axis("L=4,5, 6,7").values == Words{"4", "5", "6", "7"});
    CHECK(parse_axis("D=0.01:0.08:8").values == Words{"0.01", "0.02", "0.03", "0.04", "0.05", "0.06", "0.07", "0.08"});
    CHECK(parse_axis("D=0.1:0.1:1").values == Words{"0.1"});
    CHECK(parse_axis("D=log:0.1:1000:5").values == Words{"0.1", "1", "10", "100", "1000"});
    CHECK(parse_axis("D=log:0.1:1000:5").name == "D");
    CHECK(parse_axis("L=-1:1:3").values == Words{"-1", "0", "1"});
}

TEST_CASE("words that are no values are answered with what was meant") {
    const auto problem = [](const std::string& word) {
        try {
            parse_axis(word);
        } catch (const Error& error) {
            return std::string(error.what());
        }
        return std::string("none");
    };
    for (const char* word : {"D", "=1:2:3", "D="}) CHECK_THAT(problem(word), Contains("values are given as in NAME="));
    for (const char* word : {"D=1:2", "D=log:1:2", "D=1:x:3", "D=1:2:3:4", "D=log:1"})
        CHECK_THAT(problem(word), Contains("a range is written"));
    CHECK_THAT(problem("D=2:1:3"), Contains("2 is above 1"));
    CHECK_THAT(problem("D=log:0:1:3"), Contains("begins above 0"));
    for (const char* word : {"D=1:2:0", "D=1:2:1.5", "D=1:2:-3", "D=1:2:1e9", "D=1:2:many"})
        CHECK_THAT(problem(word), Contains("no count"));
    CHECK_THAT(problem("D=1,,2"), Contains("'' is not a number"));
    CHECK_THAT(problem("D=1,nan"), Contains("'nan' is not a number"));
    CHECK_THAT(problem("D=" + std::string(500, 'x')), Contains("..."));
}

TEST_CASE("a grid has all combinations, the first axis changing fastest, and all again for each replicate") {
    const std::vector<Point> points = grid({parse_axis("A=1,2,3"), parse_axis("B=10,20")}, 2);
    REQUIRE(points.size() == 12);
    CHECK(points[1].settings[0].value == "2");
    CHECK(points[3].settings[0].value == "1");
    CHECK(points[3].settings[1].value == "20");
    CHECK(points[5].replicate == 0);
    CHECK(points[6].replicate == 1);
    CHECK(points[6].settings[0].value == "1");
    CHECK_THROWS_WITH(grid({parse_axis("A=1,2"), parse_axis("A=3,4")}, 1), Contains("A is given twice"));
    CHECK_THROWS_WITH(grid({parse_axis("A=0:1:2000"), parse_axis("B=0:1:2000")}, 1),
                      Contains("more than 1000000 tiles"));
}

TEST_CASE("samples lie within their ranges, and a Latin hypercube has one in each part of every range") {
    const std::vector<Range> ranges{parse_range("A=2:4"), parse_range("B=log:0.01:100")};
    const std::vector<Point> free = samples(ranges, 40, false, 3), latin = samples(ranges, 40, true, 3);
    CHECK(free == samples(ranges, 40, false, 3));
    CHECK_FALSE(free == samples(ranges, 40, false, 4));
    std::set<int> parts_a, parts_b, order;
    for (const auto* points : {&free, &latin}) {
        for (const Point& point : *points) {
            CHECK((value(point, 0) >= 2 && value(point, 0) <= 4 && value(point, 1) >= 0.01 && value(point, 1) <= 100));
        }
    }
    for (const Point& point : latin) {
        parts_a.insert(static_cast<int>((value(point, 0) - 2) / 2 * 40));
        parts_b.insert(static_cast<int>((std::log10(value(point, 1)) + 2) / 4 * 40));
    }
    CHECK(parts_a.size() >= 39);  // six digits may carry a value over an edge
    CHECK(parts_b.size() >= 39);
    const auto rising = [](const Point& a, const Point& b) { return value(a, 0) < value(b, 0); };
    CHECK_FALSE(std::ranges::is_sorted(latin, rising));
}

TEST_CASE("a table of points, and tables that are none") {
    const test::Folder folder;
    const auto problem = [&](const std::string& text) {
        try {
            read_points(folder.write("points.csv", text));
        } catch (const Error& error) {
            return std::string(error.what());
        }
        return std::string("none");
    };
    const std::vector<Point> points = read_points(folder.write("good.csv", "F, K\r\n0.03,0.06\r\n\r\n0.04, 0.061\n"));
    REQUIRE(points.size() == 2);
    CHECK(points[1].settings[1].name == "K");
    CHECK(points[1].settings[1].value == "0.061");
    CHECK(read_points(folder.write("mark.csv",
                                   "\xef\xbb\xbf"
                                   "F\n1\n"))
              .at(0)
              .settings.at(0)
              .name == "F");
    const std::vector<Point> quoted =
        read_points(folder.write("quoted.csv", "\"F\", \"K\" \n\"0.03\",\"0.06\"\n 0.04,\"5\"\n"));
    REQUIRE(quoted.size() == 2);
    CHECK(quoted[0].settings[0].name == "F");
    CHECK(quoted[0].settings[1].name == "K");
    CHECK(quoted[0].settings[1].value == "0.06");
    CHECK(quoted[1].settings[0].value == "0.04");
    CHECK(quoted[1].settings[1].value == "5");
    CHECK_THAT(problem("F,K\n1,\"1,5\"\n"), Contains("points.csv:2: '1,5' is not a number"));
    CHECK_THAT(problem("F,K\n1,\"a\"\"b\"\n"), Contains("'a\"b' is not a number"));
    CHECK_THAT(problem("F,K\n1,\"2\n"), Contains("points.csv:2: a quote is not closed"));
    CHECK_THAT(problem("F,F\n1,2\n"), Contains("points.csv:1: a name stands there twice"));
    CHECK_THAT(problem("F,K\n1,2\n1\n"), Contains("points.csv:3: 1 field; the first line names 2"));
    CHECK_THAT(problem("F,K\n1,x\n"), Contains("points.csv:2: 'x' is not a number"));
    CHECK_THAT(problem("F,K\n"), Contains("holds no point"));
    CHECK_THAT(problem(""), Contains("holds no point"));
    CHECK_THROWS_WITH(read_points(folder / "none.csv"), Contains("cannot be opened"));
    CHECK_THROWS_WITH(read_points(folder / "."), Contains("is a folder"));
}
