// What holds for the tissue as a whole: splits, states that are taken and given back, domains, mirrors, movement.
#include "cells_reference/runs.hpp"
#include "core/error.hpp"
#include "core/growable.hpp"
#include "core/searching.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace pelage;

namespace {

// Something of everything that changes a cell.
const std::string lively = R"(
define chemical U limit 5
define chemical V
define division_limit 6
define domain packed
define time_step 0.5
use seed 4
use chemical U conc 4 dev 1 diff 0.1
use chemical V conc 4 dev 1 diff 0.02 dev 0.01
use polarity 0 dev 90
create hex_grid 12 13 dev 0.2
rule always react U V scale 0.02 turing alpha 16 beta 12
rule every 7 always polarize V conc
rule from 10 probability 0.01 divide direction 0 dev 180
rule from 5 if AGE > 9 and
rule probability 0.3 move 0.05 dev 0.1
rule from 20 always change V diff 0 dev 0.001
stop at 60
)";

}  // namespace

TEST_CASE("advancing in parts gives the bits of advancing at once") {
    const Precision precision = GENERATE(Precision::single_, Precision::double_);
    const NeighbourSearch search =
        GENERATE(NeighbourSearch::kd_tree, NeighbourSearch::bins, NeighbourSearch::spatial_sorting);
    const auto whole = test::cells(lively, precision, search);
    const auto parts = test::cells(lively, precision, search);

    const Snapshot expected = test::after(*whole, 60);
    for (const std::uint64_t count : {1u, 0u, 9u, 11u, 1u, 38u}) parts->advance(count);

    REQUIRE(expected.cells() > 180);
    CHECK(test::same(parts->read(), expected));
}

TEST_CASE("a run goes on from a state as if it had not been stopped") {
    const Precision precision = GENERATE(Precision::single_, Precision::double_);
    const auto whole = test::cells(lively, precision);
    const Snapshot middle = test::after(*whole, 31);
    const auto resumed = test::cells(lively, middle, precision);
    const auto rewound = test::cells(lively, precision);
    rewound->advance(50);
    rewound->write(middle);

    const Snapshot expected = test::after(*whole, 29);

    CHECK(test::same(test::after(*resumed, 29), expected));
    CHECK(test::same(test::after(*rewound, 29), expected));
}

TEST_CASE("bins and k-d tree are one search here, spatial sorting is another and says what it misses") {
    const auto bins = test::cells(lively, Precision::single_, NeighbourSearch::bins);
    const auto tree = test::cells(lively, Precision::single_, NeighbourSearch::kd_tree);
    const auto sorting = test::cells(lively, Precision::single_, NeighbourSearch::spatial_sorting);

    CHECK(test::same(test::after(*bins, 40), test::after(*tree, 40)));
    sorting->advance(40);

    CHECK_FALSE(search_statistics(*bins).has_value());
    CHECK_FALSE(search_statistics(*tree).has_value());
    REQUIRE(search_statistics(*sorting).has_value());
    CHECK(search_statistics(*sorting)->neighbours_exact > 500);
    CHECK(search_statistics(*sorting)->miss_rate() < 0.2);
}

TEST_CASE("float and double agree to rounding while nothing amplifies it") {
    const std::string text = R"(
define chemical U
define chemical V
use seed 6
use chemical U conc 4 dev 1 diff 0.05
use chemical V conc 4 dev 1 diff 0.01
create hex_grid 15 15 dev 0.2
rule always react U V scale 0.02 turing alpha 16 beta 12
stop at 10
)";
    const auto twin = test::cells(text, Precision::single_);
    const auto truth = test::cells(text, Precision::double_);

    const Snapshot found = test::after(*twin, 10);
    const Snapshot expected = test::after(*truth, 10);

    double largest = 0;
    for (std::size_t cell = 0; cell < found.cells(); ++cell) {
        largest = std::max(largest, std::abs(found.conc[0][cell] - expected.conc[0][cell]));
    }
    CHECK(largest > 0);
    CHECK(largest < 1e-3);
}

TEST_CASE("cells stay inside the domain") {
    const std::string text = R"(
define chemical U
define domain 20 8
use polarity 30
create hex_grid 6 5
rule always move 1.5
stop at 10
)";
    const auto tissue = test::cells(text);

    const Snapshot state = test::after(*tissue, 30);

    for (std::size_t cell = 0; cell < state.cells(); ++cell) {
        CHECK(std::abs(state.x[cell]) <= 10);
        CHECK(std::abs(state.y[cell]) <= 4);
    }
    CHECK(*std::max_element(state.x.begin(), state.x.end()) == 10);
    CHECK(*std::max_element(state.y.begin(), state.y.end()) == 4);
}

TEST_CASE("a packed domain grows with the number of cells at the start of the iteration") {
    const std::string text = R"(
define chemical U
define domain packed area 4
create hex_grid 10 10
rule from 1 until 1 always divide direction 90
rule always move 3
use polarity 0
create cell 0 0
stop at 10
)";
    const auto tissue = test::cells(text);
    const auto edge = [&] {
        const Snapshot state = test::after(*tissue, 1);
        return *std::max_element(state.x.begin(), state.x.end());
    };

    const double before = edge();
    edge();
    for (int i = 0; i < 20; ++i) tissue->advance(1);
    const double later = edge();

    CHECK(tissue->cells() == 202);
    CHECK(before == (std::sqrt(101 * 4.0) - 2) / 2);
    CHECK(later == (std::sqrt(202 * 4.0) - 2) / 2);
}

TEST_CASE("move follows the old polarity, fixed cells too, and deviates within its range") {
    const std::string text = R"(
define chemical U
use seed 2
use polarity 0
create cell 0 0 fixed
create hex_grid 20 20 at 0 100
rule always move 0.5 dev 0.25
stop at 10
)";
    const Snapshot before = test::initial(text);
    const auto tissue = test::cells(text);

    const Snapshot state = test::after(*tissue, 1);

    double low = 1, high = 0;
    for (std::size_t cell = 0; cell < state.cells(); ++cell) {
        const double step = state.x[cell] - before.x[cell];
        low = std::min(low, step);
        high = std::max(high, step);
        CHECK(state.y[cell] == before.y[cell]);
    }
    CHECK(state.x[0] != 0);
    CHECK(low > 0.25 - 1e-6);
    CHECK(low < 0.26);
    CHECK(high < 0.75 + 1e-6);
    CHECK(high > 0.74);
}

TEST_CASE("mirror pairs end every iteration with the mean of both, pair after pair") {
    const std::string text = R"(
define chemical U
use chemical U conc 1 diff 0
create cell 0 0
create cell 10 0
create cell 20 0
set cell 0 chemical U conc 8
set cell 2 chemical U conc 4
set cell 2 chemical U diff 0.5
rule always change U conc 0
stop at 10
)";
    Snapshot before = test::initial(text);
    before.mirrors = {{0, 1}, {1, 2}};
    const auto tissue = test::cells(text, before);

    const Snapshot state = test::after(*tissue, 1);

    CHECK(state.conc[0] == std::vector<double>{4.5, 4.25, 4.25});
    CHECK(state.diff[0] == std::vector<double>{0, 0.25, 0.25});
}

TEST_CASE("set replaces what diffusion made, and bounds hold afterwards") {
    const std::string text = R"(
define chemical U limit 3 floor 1
use chemical U conc 2 diff 0.1
create cell 0 0
create cell 2 0
create cell 4 0
rule if X < 1 set U conc 7
rule if X > 3 set U conc -2
rule if X > 3 set U diff -1
stop at 10
)";
    const auto tissue = test::cells(text);

    const Snapshot state = test::after(*tissue, 1);

    CHECK(state.conc[0] == std::vector<double>{3, 2, 1});
    CHECK(state.diff[0][2] == 0);
}

TEST_CASE("phases change time step, bounds and rates where they begin") {
    const std::string text = R"(
define chemical U
use chemical U conc 0
create cell 0 0
create cell 2 0
set cell 0 chemical U conc 8
phase "first" 3
rule always change U conc 1
phase "second" 3
define time_step 0.5
define chemical U limit 10
use chemical U diff 0.25
)";
    const auto tissue = test::cells(text);

    const Snapshot first = test::after(*tissue, 3);
    const Snapshot second = test::after(*tissue, 1);

    CHECK(first.conc[0] == std::vector<double>{11, 3});
    CHECK(second.conc[0] == std::vector<double>{10, 4});
}

TEST_CASE("the first concentration that is not finite is told") {
    const std::string text = R"(
define chemical U
define chemical V
create cell 0 0
create cell 5 0
rule always change V conc 1
stop at 10
)";
    Snapshot before = test::initial(text);
    before.conc[1][1] = INFINITY;
    const auto tissue = test::cells(text, before);

    tissue->advance(1);

    const auto found = tissue->non_finite();
    REQUIRE(found.has_value());
    CHECK(found->chemical == 1);
    CHECK(found->cell == 1);
    CHECK_FALSE(test::cells(text)->non_finite().has_value());
}

TEST_CASE("free cells refuse what only a lattice can") {
    const auto tissue = test::cells(lively);
    Snapshot lattice = tissue->read();
    lattice.columns = 12;
    lattice.rows = 13;

    CHECK_THROWS_AS(growable(*tissue).expand({true, {0, 0}}), Error);
    CHECK_THROWS_AS(tissue->write(lattice), Error);
    CHECK_THROWS_AS(test::cells(lively, lattice), Error);
}
