// create and set: what they put into the Experiment, and how many cells there are for `set`.
#include "core/prepattern.hpp"
#include "language/error_case.hpp"
#include "language/parsed.hpp"

#include <catch2/catch.hpp>

#include <fmt/format.h>

using namespace pelage;
using namespace test;

namespace {

template <class Created>
Created created(const std::string& text) {
    return std::get<Created>(parsed("define chemical U\n" + text).prepattern.at(0));
}

}  // namespace

TEST_CASE("a cell") {
    const auto cell = created<CreateCell>("create cell 1.5 -2 fixed");

    CHECK(cell.x == 1.5);
    CHECK(cell.y == -2.0);
    CHECK(cell.fixed);
    CHECK_FALSE(created<CreateCell>("create cell 0 0").fixed);
}

TEST_CASE("grids take their options in any order") {
    const auto grid_a = created<CreateGrid>("create sqr_grid 30 10 at 0 -20 dev 0.5 fixed wrap");
    const auto grid_b = created<CreateGrid>("create sqr_grid 30 10 wrap fixed dev 0.5 at 0 -20");

    for (const CreateGrid& grid : {grid_a, grid_b}) {
        CHECK(grid.arrangement == Arrangement::sqr_grid);
        CHECK(grid.columns == 30);
        CHECK(grid.rows == 10);
        CHECK(grid.x == 0.0);
        CHECK(grid.y == -20.0);
        CHECK(grid.deviation == 0.5);
        CHECK(grid.fixed);
        CHECK(grid.wrap);
    }
}

TEST_CASE("every arrangement") {
    CHECK(created<CreateGrid>("create sqr_grid 3 4").arrangement == Arrangement::sqr_grid);
    CHECK_FALSE(created<CreateGrid>("create sqr_grid 3 4").wrap);
    CHECK(created<CreateGrid>("create hex_grid 3 4 fixed").arrangement == Arrangement::hex_grid);
    CHECK(created<CreateGrid>("create hex_grid 3 4 fixed").fixed);
    const auto square = created<CreateGrid>("create sqr_circle 9 at 1 2 dev 0.1");
    CHECK(square.arrangement == Arrangement::sqr_circle);
    CHECK(square.columns == 9);
    CHECK(square.rows == 0);
    CHECK(square.x == 1.0);
    const auto hex = created<CreateGrid>("create hex_circle 45");
    CHECK(hex.arrangement == Arrangement::hex_circle);
    CHECK(hex.columns == 45);
    CHECK(hex.rows == 0);
}

TEST_CASE("a matrix has one of three boundaries") {
    const auto plain = created<CreateMatrix>("create matrix 20 10");
    CHECK(plain.columns == 20);
    CHECK(plain.rows == 10);
    CHECK(plain.boundary == Boundary::no_flux);
    CHECK(plain.x == 0.0);

    CHECK(created<CreateMatrix>("create matrix 20 10 no-flux").boundary == Boundary::no_flux);
    CHECK(created<CreateMatrix>("create matrix 20 10 wrap").boundary == Boundary::wrap);
    const auto last = created<CreateMatrix>("create matrix 20 10 at 5 6 absorbing");
    CHECK(last.boundary == Boundary::absorbing);
    CHECK(last.x == 5.0);
    CHECK(last.y == 6.0);
}

TEST_CASE("one line may set concentration, rate, polarity and fixation, in that order of drawing") {
    const Experiment e =
        parsed_on_grid("set cells 3 to 40 chemical V conc 4 dev 2 diff 0.5 dev 0.25 polarity none fixed\n");

    REQUIRE(e.prepattern.size() == 5);
    for (std::size_t i = 1; i < 5; ++i) {
        CHECK(std::get<SetCells>(e.prepattern[i]).first == 3);
        CHECK(std::get<SetCells>(e.prepattern[i]).last == 40);
    }
    const auto conc = std::get<SetConcentration>(std::get<SetCells>(e.prepattern[1]).what);
    CHECK(conc.chemical == 1);
    CHECK(conc.value.value == 4.0);
    CHECK(conc.value.deviation == 2.0);
    const auto rate = std::get<SetRate>(std::get<SetCells>(e.prepattern[2]).what);
    CHECK(rate.chemical == 1);
    CHECK(rate.value.value == 0.5);
    CHECK(rate.value.deviation == 0.25);
    CHECK_FALSE(std::get<SetPolarity>(std::get<SetCells>(e.prepattern[3]).what).degrees.has_value());
    CHECK(std::holds_alternative<SetFixed>(std::get<SetCells>(e.prepattern[4]).what));
}

TEST_CASE("one cell") {
    const Experiment e = parsed_on_grid("set cell 99 polarity 45 dev 10\nset cell 0 chemical U diff 2\n");

    const auto first = std::get<SetCells>(e.prepattern.at(1));
    CHECK(first.first == 99);
    CHECK(first.last == 99);
    CHECK(std::get<SetPolarity>(first.what).degrees->value == 45.0);
    CHECK(std::get<SetPolarity>(first.what).degrees->deviation == 10.0);
    CHECK(std::get<SetRate>(std::get<SetCells>(e.prepattern.at(2)).what).value.value == 2.0);
}

TEST_CASE("set knows how many cells there are so far") {
    const std::string statement =
        GENERATE(as<std::string>(), "create cell 0 0", "create sqr_grid 4 5", "create hex_grid 4 5",
                 "create sqr_circle 7", "create hex_circle 6", "create matrix 6 3");
    const std::string prelude = "define chemical U\n" + statement + "\n";
    const std::size_t cells = initial_state(parsed(prelude)).cells();

    CHECK(message_of(prelude + fmt::format("set cell {} fixed", cells - 1)) == "(none)");
    CHECK(message_of(prelude + fmt::format("set cell {} fixed", cells)) ==
          fmt::format("t.pex:3:10: '{}' is out of range; the cell must be a whole number from 0 to {}", cells,
                      cells - 1));
}

TEST_CASE("set counts the cells of all statements before it, not after") {
    const std::string two = "define chemical U\ncreate cell 0 0\nset cell 1 fixed\ncreate cell 5 0\n";
    const std::string after = "define chemical U\ncreate cell 0 0\ncreate cell 5 0\nset cell 1 fixed\n";

    CHECK(message_of(two) == "t.pex:3:10: '1' is out of range; the cell must be a whole number from 0 to 0");
    CHECK(message_of(after) == "(none)");
}
