// The comparators themselves: they must see the smallest difference, and mistrust what proves nothing.
#include "verify/compare.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

using pelage::Snapshot;
using namespace pelage::verify;

namespace {

Snapshot state(std::size_t columns, std::size_t rows) {
    Snapshot made;
    const std::size_t cells = columns * rows;
    made.columns = columns;
    made.rows = rows;
    std::vector<double> values(cells);
    for (std::size_t i = 0; i < cells; ++i) values[i] = 1.0 + static_cast<double>(i % 977) / 1024;
    made.conc = {values, values};
    made.diff = {values, values};
    made.mappings = {values};
    made.x = made.y = made.polarity_x = made.polarity_y = values;
    made.birth.assign(cells, 3);
    made.neighbours.assign(cells, 8);
    made.fixed.assign(cells, 0);
    return made;
}

}  // namespace

TEST_CASE("equal states have no differences") { REQUIRE(differences(state(1000, 1000), state(1000, 1000)).empty()); }

TEST_CASE("one wrong bit in a million cells is seen, and where") {
    const Snapshot expected = state(1000, 1000);
    Snapshot found = expected;
    found.conc[1][654'321] = std::nextafter(found.conc[1][654'321], 2.0);

    const auto lines = differences(expected, found);

    REQUIRE(lines.size() == 1);
    REQUIRE(lines.front().find("conc[1]: 1 of 1000000 elements differ, first [654321]") == 0);
}

TEST_CASE("a NaN is never equal, not even to itself") {
    Snapshot expected = state(7, 3);
    expected.conc[0][5] = std::numeric_limits<double>::quiet_NaN();

    REQUIRE(differences(expected, expected).size() == 1);
}

TEST_CASE("zeros of different sign differ") {
    Snapshot expected = state(7, 3);
    expected.polarity_y[20] = 0.0;
    Snapshot found = expected;
    found.polarity_y[20] = -0.0;

    REQUIRE(differences(expected, found).size() == 1);
}

TEST_CASE("a missing last element and a missing chemical are seen") {
    const Snapshot expected = state(7, 3);
    Snapshot shorter = expected;
    shorter.conc[0].pop_back();
    Snapshot fewer = expected;
    fewer.conc.pop_back();

    REQUIRE(differences(expected, shorter).size() == 1);
    REQUIRE(differences(expected, fewer).size() == 1);
}

TEST_CASE("a row shifted by one cell is seen") {
    const Snapshot expected = state(31, 5);
    Snapshot found = expected;
    std::rotate(found.conc[0].begin() + 31, found.conc[0].begin() + 32, found.conc[0].begin() + 62);

    REQUIRE(differences(expected, found).size() == 1);
}

TEST_CASE("every array is compared") {
    const Snapshot expected = state(4, 3);
    const auto seen = [&](auto change) {
        Snapshot found = expected;
        change(found);
        return differences(expected, found).size() == 1;
    };

    REQUIRE(seen([](Snapshot& s) { s.iteration = 1; }));
    REQUIRE(seen([](Snapshot& s) { std::swap(s.columns, s.rows); }));
    REQUIRE(seen([](Snapshot& s) { s.origin_x = 0.5; }));
    REQUIRE(seen([](Snapshot& s) { s.origin_y = 0.5; }));
    REQUIRE(seen([](Snapshot& s) { s.diff[1][11] += 1; }));
    REQUIRE(seen([](Snapshot& s) { s.mappings[0][0] += 1; }));
    REQUIRE(seen([](Snapshot& s) { s.x[3] += 1; }));
    REQUIRE(seen([](Snapshot& s) { s.y[3] += 1; }));
    REQUIRE(seen([](Snapshot& s) { s.polarity_x[3] += 1; }));
    REQUIRE(seen([](Snapshot& s) { s.polarity_y[3] += 1; }));
    REQUIRE(seen([](Snapshot& s) { s.birth[11] = 4; }));
    REQUIRE(seen([](Snapshot& s) { s.neighbours[11] = 4; }));
    REQUIRE(seen([](Snapshot& s) { s.fixed[11] = 1; }));
    REQUIRE(seen([](Snapshot& s) { s.mirrors.emplace_back(1, 2); }));
}

TEST_CASE("flat and unchanged results are mistrusted") {
    const Snapshot before = state(9, 9);
    Snapshot after = before;
    for (double& value : after.conc[0]) value += 0.5;
    REQUIRE(mistrusted(before, after).size() == 1);  // conc[1] is as it was

    after.conc[1].assign(81, 2.0);
    const auto lines = mistrusted(before, after);

    REQUIRE(lines.size() == 1);
    REQUIRE(lines.front() == "mistrusted: conc[1] is flat");
}
