// The counting of differences: it must see the smallest one, say where it is and how large.
#include "verify/tally.hpp"

#include <catch2/catch.hpp>

#include <bit>
#include <cmath>
#include <limits>

using namespace pelage;
using namespace pelage::verify;
using Catch::Matchers::Contains;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

Snapshot sample() {
    Snapshot made;
    made.columns = 40;
    made.rows = 25;
    std::vector<double> values(1000);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = 1 + static_cast<double>(i) / 1024;
    made.conc = {values, values};
    made.diff = {values, values};
    made.mappings = {values};
    made.x = made.y = made.polarity_x = made.polarity_y = values;
    made.birth.assign(1000, 3);
    made.neighbours.assign(1000, 8);
    made.fixed.assign(1000, 0);
    return made;
}

Tally compared(const Snapshot& expected, const Snapshot& found) {
    Tally tally;
    add(tally, expected, found, Precision::single_, "here");
    return tally;
}

}  // namespace

TEST_CASE("equal states count their cells and nothing else") {
    const Tally tally = compared(sample(), sample());

    REQUIRE(tally.equal());
    REQUIRE(tally.cells_compared == 1000);
    REQUIRE(tally.max_ulp == 0);
}

TEST_CASE("one step of a float is one ulp, of one cell, with row, column and both bit patterns") {
    Snapshot found = sample();
    const auto before = static_cast<float>(found.conc[1][163]);
    found.conc[1][163] = static_cast<double>(std::nextafter(before, 9.0f));

    const Tally tally = compared(sample(), found);

    REQUIRE(tally.cells_differing == 1);
    REQUIRE(tally.max_ulp == 1);
    REQUIRE(tally.max_absolute == Approx(0x1p-23));
    REQUIRE_THAT(tally.first, Contains("here: conc[1] of cell 163 (row 4, column 3)"));
    REQUIRE_THAT(tally.first, Contains("0x3f946000") && Contains("0x3f946001"));
}

TEST_CASE("a cell that differs in many values is one cell") {
    Snapshot found = sample();
    found.conc[0][7] += 1;
    found.diff[1][7] += 1;
    found.birth[7] = 0;
    found.x[9] += 1;

    REQUIRE(compared(sample(), found).cells_differing == 2);
}

TEST_CASE("every array is looked at") {
    const Snapshot expected = sample();
    const auto change = GENERATE(
        as<void (*)(Snapshot&)>{}, [](Snapshot& s) { s.conc[0][999] += 1; }, [](Snapshot& s) { s.diff[1][0] += 1; },
        [](Snapshot& s) { s.mappings[0][5] += 1; }, [](Snapshot& s) { s.x[5] += 1; }, [](Snapshot& s) { s.y[5] += 1; },
        [](Snapshot& s) { s.polarity_x[5] += 1; }, [](Snapshot& s) { s.polarity_y[5] += 1; },
        [](Snapshot& s) { s.birth[5] += 1; }, [](Snapshot& s) { s.neighbours[5] += 1; },
        [](Snapshot& s) { s.fixed[5] = 1; }, [](Snapshot& s) { s.mirrors.emplace_back(1, 2); },
        [](Snapshot& s) { s.order = {0}; }, [](Snapshot& s) { s.iteration = 4; }, [](Snapshot& s) { s.rows = 24; },
        [](Snapshot& s) { s.conc.pop_back(); }, [](Snapshot& s) { s.y.pop_back(); });
    Snapshot found = expected;

    change(found);

    REQUIRE_FALSE(compared(expected, found).equal());
    REQUIRE(compared(expected, found).cells_differing > 0);
}

TEST_CASE("signs of zero differ, NaNs are one value, a NaN in one place alone is not") {
    Snapshot expected = sample();
    expected.conc[0][1] = 0.0;
    expected.conc[0][2] = not_a_number;
    Snapshot found = expected;
    found.conc[0][2] = -not_a_number;
    REQUIRE(compared(expected, found).equal());

    found.conc[0][1] = -0.0;
    REQUIRE(compared(expected, found).cells_differing == 1);
    REQUIRE(compared(expected, found).max_ulp == 0);
    found.conc[0][3] = not_a_number;
    REQUIRE(compared(expected, found).cells_differing == 2);
    REQUIRE(compared(expected, found).max_relative == infinite);
}

TEST_CASE("what a device gave has a fingerprint of its own") {
    Snapshot other = sample();
    other.diff[0][500] = std::nextafter(other.diff[0][500], 9.0);

    REQUIRE(compared(sample(), sample()).found.value() == compared(other, sample()).found.value());
    REQUIRE(compared(sample(), sample()).found.value() != compared(sample(), other).found.value());
}

TEST_CASE("steps between numbers are counted across zero") {
    const double tiny = static_cast<double>(std::numeric_limits<float>::denorm_min());
    REQUIRE(ulps(tiny, -tiny, Precision::single_) == 2);
    REQUIRE(ulps(1.0, 1.0 + 0x1p-52, Precision::double_) == 1);
    REQUIRE(ulps(1.0, 2.0, Precision::single_) == 1u << 23);
    REQUIRE(ulps(1.0, not_a_number, Precision::single_) == std::numeric_limits<std::uint64_t>::max());
}

TEST_CASE("arrays of another length differ by what is missing") {
    const std::vector<std::uint32_t> expected{1, 2, 3, 4};
    const std::vector<std::uint32_t> found{1, 2, 4};
    Tally tally;

    add(tally, expected, found, "words");

    REQUIRE(tally.cells_differing == 2);
    REQUIRE_THAT(tally.first, Contains("3 values, expected 4"));
}
