// Laws of free cells: conservation, symmetry of collisions, independence of names and of place.
#include "cells_reference/runs.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

using namespace pelage;

namespace {

// Jittered, unequal rates, without bounds, reaction or division.
const std::string diffusing = R"(
define chemical U floor none
define chemical V floor none anisotropic
use seed 3
use chemical U conc 4 dev 3 diff 0.05 dev 0.05
use chemical V conc 2 dev 2 diff 0.08 dev 0.02
use polarity 30 dev 180
create hex_grid 17 19 dev 0.3
rule from 1000 always change U conc 0
stop at 10
)";

double total(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

double spread(const std::vector<double>& values) {
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    return *high - *low;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
    return largest;
}

// The same cells under other ids: cell i becomes cell places[i].
Snapshot renamed(const Snapshot& from, const std::vector<std::size_t>& places) {
    Snapshot to = from;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const std::size_t at = places[i];
        for (std::size_t c = 0; c < from.conc.size(); ++c) {
            to.conc[c][at] = from.conc[c][i];
            to.diff[c][at] = from.diff[c][i];
        }
        to.x[at] = from.x[i];
        to.y[at] = from.y[i];
        to.polarity_x[at] = from.polarity_x[i];
        to.polarity_y[at] = from.polarity_y[i];
        to.birth[at] = from.birth[i];
        to.neighbours[at] = from.neighbours[i];
        to.fixed[at] = from.fixed[i];
    }
    return to;
}

}  // namespace

TEST_CASE("diffusion without bounds conserves every chemical") {
    const Snapshot before = test::initial(diffusing);
    const auto tissue = test::cells(diffusing);

    const Snapshot later = test::after(*tissue, 300);

    for (std::size_t c = 0; c < 2; ++c) {
        CHECK(spread(later.conc[c]) < 0.5 * spread(before.conc[c]));
        CHECK(total(later.conc[c]) == Approx(total(before.conc[c])).epsilon(1e-13));
    }
}

TEST_CASE("two cells that overlap separate symmetrically until they touch") {
    const auto tissue = test::cells("define chemical U\ncreate cell 0.25 -3\ncreate cell 0.75 -3\nstop at 10\n");

    const Snapshot first = test::after(*tissue, 1);
    const Snapshot later = test::after(*tissue, 60);

    // Each moves by (0.25 - 0.5 / 0.5) * 0.5.
    CHECK(first.x == std::vector<double>{0.25 - 0.375, 0.75 + 0.375});
    CHECK(first.y == std::vector<double>{-3, -3});
    CHECK(later.x[0] + later.x[1] == Approx(1.0).epsilon(1e-14));
    CHECK(later.x[1] - later.x[0] == Approx(2.0).epsilon(1e-12));
    CHECK(later.neighbours == std::vector<std::int32_t>{1, 1});
}

TEST_CASE("collisions of many cells leave their centre where it is") {
    const std::string crowd = "define chemical U\nuse seed 5\ncreate hex_grid 12 14 dev 1.2\nstop at 10\n";
    const Snapshot before = test::initial(crowd);
    const auto tissue = test::cells(crowd);

    const Snapshot later = test::after(*tissue, 200);

    REQUIRE(largest_difference(before.x, later.x) > 0.5);
    CHECK(std::abs(total(later.x) - total(before.x)) < 1e-10);
    CHECK(std::abs(total(later.y) - total(before.y)) < 1e-10);
}

TEST_CASE("cells that touch or are further apart than two radii do not push") {
    const auto tissue =
        test::cells("define chemical U\ncreate cell 0 0\ncreate cell 2 0\ncreate cell 0 2.5\nstop at 10\n");

    const Snapshot later = test::after(*tissue, 20);

    CHECK(later.x == std::vector<double>{0, 2, 0});
    CHECK(later.y == std::vector<double>{0, 0, 2.5});
    CHECK(later.neighbours == std::vector<std::int32_t>{2, 1, 1});
}

TEST_CASE("a fixed cell pushes but is not pushed") {
    const auto tissue = test::cells("define chemical U\ncreate cell 0 0 fixed\ncreate cell 1 0\nstop at 10\n");

    const Snapshot later = test::after(*tissue, 1);

    CHECK(later.x == std::vector<double>{0, 1.25});
}

TEST_CASE("cells at one and the same place exchange chemicals and stay together") {
    const std::string text = R"(
define chemical U anisotropic
use chemical U conc 1 diff 0.125
use polarity 0
create cell 4 4
use chemical U conc 3
create cell 4 4
rule always polarize U conc
stop at 10
)";
    const auto tissue = test::cells(text);

    const Snapshot later = test::after(*tissue, 1);

    CHECK(later.conc[0] == std::vector<double>{1.25, 2.75});
    CHECK(later.x == std::vector<double>{4, 4});
    CHECK(later.polarity_x == std::vector<double>{1, 1});
    CHECK(later.polarity_y == std::vector<double>{0, 0});
    CHECK(later.neighbours == std::vector<std::int32_t>{1, 1});
}

TEST_CASE("a cell at the place of another keeps its polarity, whatever else lies around") {
    const double between = GENERATE(0.0, 1e-200);  // the square of the latter vanishes
    const NeighbourSearch search = GENERATE(NeighbourSearch::kd_tree, NeighbourSearch::spatial_sorting);
    CAPTURE(between, static_cast<int>(search));
    const std::string text = R"(
define chemical U
use chemical U conc 1
use polarity 90
create cell 0 0
create cell 0 0
use chemical U conc 3
create cell 2.5 0
create cell -2.5 0
rule always polarize U conc
stop at 10
)";
    Snapshot state = test::initial(text);
    state.x[1] = between;
    state.conc[0][3] = 2;
    const auto tissue = test::cells(text, state, Precision::double_, search);

    const Snapshot later = test::after(*tissue, 1);

    CHECK(later.neighbours == std::vector<std::int32_t>{3, 3, 2, 2});
    CHECK(later.polarity_x == std::vector<double>{state.polarity_x[0], state.polarity_x[1], 1, -1});
    CHECK(later.polarity_y == std::vector<double>{state.polarity_y[0], state.polarity_y[1], 0, 0});
}

TEST_CASE("impermeable cells exchange nothing") {
    const std::string text = R"(
define chemical U
use seed 2
use chemical U conc 5 dev 2 diff 0.1
create hex_grid 11 12
set cells 40 to 80 chemical U diff 0
stop at 10
)";
    const Snapshot before = test::initial(text);
    const auto tissue = test::cells(text);

    const Snapshot later = test::after(*tissue, 100);

    std::size_t changed = 0;
    for (std::size_t cell = 0; cell < before.cells(); ++cell) {
        if (cell >= 40 && cell <= 80) CHECK(later.conc[0][cell] == before.conc[0][cell]);
        changed += later.conc[0][cell] != before.conc[0][cell] ? 1 : 0;
    }
    CHECK(changed == before.cells() - 41);
}

TEST_CASE("other ids give other orders of summation and nothing else") {
    const Snapshot before = test::initial(diffusing);
    std::vector<std::size_t> places(before.cells());
    std::iota(places.begin(), places.end(), 0u);
    std::shuffle(places.begin(), places.end(), std::mt19937(4));
    const auto straight = test::cells(diffusing);
    const auto mixed = test::cells(diffusing, renamed(before, places));

    const Snapshot expected = renamed(test::after(*straight, 50), places);
    const Snapshot found = test::after(*mixed, 50);

    REQUIRE(largest_difference(expected.conc[0], before.conc[0]) > 0.5);
    for (std::size_t c = 0; c < 2; ++c) CHECK(largest_difference(found.conc[c], expected.conc[c]) < 1e-12);
    CHECK(largest_difference(found.x, expected.x) < 1e-12);
    CHECK(found.neighbours == expected.neighbours);
}

TEST_CASE("a tissue moved by a power of two computes the same bits") {
    const Precision precision = GENERATE(Precision::single_, Precision::double_);
    const std::string text = "define domain 40000 40000\n" + diffusing + "rule always polarize U conc\n";
    Snapshot here = test::initial(text);
    for (double& x : here.x) x = std::round(x * 256) / 256;  // so that the sums below are exact in float
    for (double& y : here.y) y = std::round(y * 256) / 256;
    std::ranges::fill(here.fixed, std::uint8_t{1});
    Snapshot there = here;
    for (double& x : there.x) x += 4096;
    for (double& y : there.y) y -= 8192;

    const Snapshot expected = test::after(*test::cells(text, here, precision), 40);
    const Snapshot found = test::after(*test::cells(text, there, precision), 40);

    REQUIRE(largest_difference(expected.conc[0], here.conc[0]) > 0.5);
    CHECK(found.conc == expected.conc);
    CHECK(found.polarity_x == expected.polarity_x);
    CHECK(found.neighbours == expected.neighbours);
}

TEST_CASE("an anisotropic chemical spreads along polarity only") {
    const std::string text = R"(
define chemical U anisotropic
use chemical U conc 0 diff 0.125
use polarity 90
create cell 0 0
create cell 2 0
create cell 0 2
set cell 0 chemical U conc 8
stop at 10
)";
    const auto tissue = test::cells(text, Precision::single_);

    const Snapshot later = test::after(*tissue, 1);

    // The cosine of 90 degrees is not quite 0 in float.
    CHECK(later.conc[0][0] == Approx(7).epsilon(1e-6));
    CHECK(std::abs(later.conc[0][1]) < 1e-6);
    CHECK(later.conc[0][2] == Approx(1).epsilon(1e-6));
}

TEST_CASE("unequal rates meet in their harmonic mean") {
    const std::string text = R"(
define chemical U
define time_step 0.5
use chemical U conc 0 diff 0.1
create cell 0 0
use chemical U conc 3 diff 0.3
create cell 0 2
stop at 10
)";
    const auto tissue = test::cells(text);

    const Snapshot later = test::after(*tissue, 1);

    // Rates reach the cells as floats.
    const double low = static_cast<double>(0.1f), high = static_cast<double>(0.3f);
    const double flow = (2 * (low * high) / (low + high) * 3) * 0.5;
    CHECK(later.conc[0] == std::vector<double>{flow, 3 - flow});
}

TEST_CASE("polarity follows the gradient and is kept where there is none") {
    const std::string text = R"(
define chemical U
use chemical U conc 1
use polarity 180
create cell 0 0
create cell 2 0
create cell 20 20
set cell 1 chemical U conc 2
rule always polarize U conc
stop at 10
)";
    const auto tissue = test::cells(text);

    const Snapshot later = test::after(*tissue, 1);

    CHECK(later.polarity_x == std::vector<double>{1, 1, -1});
    CHECK(later.polarity_y[0] == 0);
}
