// final.csv to the letter.
#include "io/csv.hpp"
#include "core/error.hpp"
#include "scratch.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <limits>

using Catch::Matchers::Contains;
using namespace pelage;
using test::Scratch;

TEST_CASE("cells as a table: exact text") {
    const Scratch scratch;
    auto cells = test::cells({0.1, -1234567.891}, {2, 1e-7});
    cells.birth = {0, 17};
    cells.neighbours = {6, 0};
    cells.polarity_x = {0.0, -0.0};
    cells.polarity_y = {0.0, static_cast<double>(0.1f)};
    cells.conc[0] = {1.0 / 3.0, std::numeric_limits<double>::infinity()};
    cells.conc[1] = {1e20, std::nan("")};

    write_csv(scratch / "final.csv", cells, test::experiment(), Precision::single_);

    CHECK(test::get(scratch / "final.csv") ==
          "id,x,y,birth,neighbours,polarity_x,polarity_y,conc U,conc V,diff U,diff V\n"
          "0,0.1,2,0,6,0,0,0.333333333,1e+20,0.125,0.03125\n"
          "1,-1234567.89,1e-07,17,0,-0,0.100000001,inf,nan,0.125,0.03125\n");
}

TEST_CASE("every float comes back from a table") {
    const Scratch scratch;
    auto cells = test::cells({0}, {0});
    for (const float value : {0.1f, 1.17549435e-38f, 3.40282347e38f, 16777217.f, 0.3333333432674408f}) {
        cells.conc[0][0] = static_cast<double>(value);

        write_csv(scratch / "final.csv", cells, test::experiment(), Precision::single_);

        const auto text = test::get(scratch / "final.csv");
        auto at = text.find('\n');
        for (int comma = 0; comma < 7; ++comma) at = text.find(',', at + 1);
        CHECK(std::stof(text.substr(at + 1)) == value);
    }
}

TEST_CASE("every double of a run in double comes back from a table, as short as may be") {
    const Scratch scratch;
    auto cells = test::cells({0.3}, {0});
    cells.birth = {4294967295u};
    for (const double value :
         {0.3, 0.30000001192092896, 1.0 / 3.0, 5e-324, 1.7976931348623157e308, -9007199254740993.0}) {
        cells.conc[0][0] = value;

        write_csv(scratch / "final.csv", cells, test::experiment(), Precision::double_);

        const auto text = test::get(scratch / "final.csv");
        CHECK_THAT(text, Contains("\n0,0.3,0,4294967295,"));
        auto at = text.find('\n');
        for (int comma = 0; comma < 7; ++comma) at = text.find(',', at + 1);
        CHECK(std::strtod(text.c_str() + at + 1, nullptr) == value);
    }
}

TEST_CASE("a table of a lattice and of many cells has a line a cell") {
    const Scratch scratch;

    write_csv(scratch / "lattice.csv", test::lattice(3, 2), test::experiment(), Precision::single_);
    write_csv(scratch / "large.csv", test::lattice(300, 200), test::experiment(), Precision::single_);
    write_csv(scratch / "none.csv", test::cells({}, {}), test::experiment(), Precision::single_);

    const auto lattice = test::get(scratch / "lattice.csv");
    const auto large = test::get(scratch / "large.csv");
    CHECK_THAT(lattice, Contains("\n0,-2,-1,0,8,0,0,0.5,-0,0.125,0.03125\n"));
    CHECK_THAT(lattice, Contains("\n5,2,1,0,8,0,0,5.5,-1.25,0.125,0.03125\n"));
    CHECK(std::count(large.begin(), large.end(), '\n') == 60001);
    CHECK_THAT(large, Contains("\n59999,299,199,"));
    CHECK(test::get(scratch / "none.csv").find('\n') == test::get(scratch / "none.csv").size() - 1);
}

TEST_CASE("odd names are quoted, arrays that do not fit refused") {
    const Scratch scratch;
    auto experiment = test::experiment();
    experiment.chemicals[0].name = "a,\"b\"";
    auto cells = test::cells({0}, {0});

    write_csv(scratch / "a.csv", cells, experiment, Precision::single_);
    cells.conc[1].clear();
    const auto text = test::error_of([&] { write_csv(scratch / "b.csv", cells, experiment, Precision::single_); });

    CHECK_THAT(test::get(scratch / "a.csv"), Contains("\"conc a,\"\"b\"\"\",conc V"));
    CHECK_THAT(text, Contains("1 cell,") && Contains("but conc for "));
    CHECK_THAT(test::error_of([&] { write_csv("/dev/full", test::cells({0}, {0}), experiment, Precision::single_); }),
               Contains("No space left"));
}
