// Textures: constant in, constant out; tileable; true to the cells.
#include "io/texture.hpp"
#include "core/error.hpp"
#include "scratch.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

using Catch::Matchers::Contains;
using namespace pelage;

namespace {

// Places that look random but are the same on every machine.
Snapshot scattered(std::size_t count) {
    std::vector<double> x;
    std::vector<double> y;
    for (std::size_t i = 0; i < count; ++i) {
        x.push_back(50 * std::fmod(static_cast<double>(i) * 0.7548776662466927, 1.0));  // Roberts' R2 sequence
        y.push_back(50 * std::fmod(static_cast<double>(i) * 0.5698402909980532, 1.0));
    }
    return test::cells(x, y);
}

Field one(const Snapshot& cells, const std::vector<double>& values, std::size_t columns, std::size_t rows,
          bool wrap = false) {
    return interpolate(cells, {values}, columns, rows, wrap)[0];
}

double greatest_difference(const std::vector<double>& a, const std::vector<double>& b) {
    REQUIRE(a.size() == b.size());
    double greatest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) greatest = std::max(greatest, std::abs(a[i] - b[i]));
    return greatest;
}

}  // namespace

TEST_CASE("weights add up to one in every texel") {
    auto clustered = scattered(300);
    for (std::size_t i = 0; i < 100; ++i)
        clustered.x[i] = clustered.y[i] = static_cast<double>(i % 3);  // on three places
    clustered.x[299] = 5000;                                           // far away
    const std::vector<Snapshot> tissues{scattered(500), clustered, test::cells({3}, {4}), test::cells({0, 9}, {0, 0}),
                                        test::lattice(7, 5)};
    for (const auto& tissue : tissues) {
        for (const std::size_t size : {3u, 64u, 200u}) {
            const auto texture = one(tissue, std::vector<double>(tissue.cells(), 0.7), size, size / 2 + 1);

            CHECK(texture.columns == size);
            CHECK(greatest_difference(texture.values, std::vector<double>(size * (size / 2 + 1), 0.7)) < 1e-12);
        }
    }
}

TEST_CASE("no texel leaves the range of the cells, and no hole is left") {
    const auto cells = scattered(400);
    std::vector<double> values;
    for (std::size_t i = 0; i < 400; ++i) values.push_back(i % 2 == 0 ? 1.0 : 2.0);

    const auto texture = one(cells, values, 300, 300);

    for (const double value : texture.values) {
        CHECK(value >= 1.0);
        CHECK(value <= 2.0);
    }
}

TEST_CASE("a texture follows a smooth field and the cells' own values") {
    const auto cells = scattered(2500);  // 50 x 50 units, about 1 apart
    const auto wave = [](double x, double y) { return std::sin(x / 5) + std::cos(y / 5); };
    std::vector<double> values;
    for (std::size_t i = 0; i < cells.cells(); ++i) values.push_back(wave(cells.x[i], cells.y[i]));

    const auto texture = one(cells, values, 520, 520);

    // The window: the bounding box of the centres and one unit around.
    const auto [left, right] = std::minmax_element(cells.x.begin(), cells.x.end());
    const auto [bottom, top] = std::minmax_element(cells.y.begin(), cells.y.end());
    const double side = std::max(*right - *left, *top - *bottom) + 2;
    double greatest = 0;
    for (std::size_t row = 30; row < 490; ++row) {
        for (std::size_t column = 30; column < 490; ++column) {
            const double x = (*left + *right - side) / 2 + (static_cast<double>(column) + 0.5) * side / 520;
            const double y = (*bottom + *top - side) / 2 + (static_cast<double>(row) + 0.5) * side / 520;
            greatest = std::max(greatest, std::abs(texture.values[row * 520 + column] - wave(x, y)));
        }
    }
    CHECK(greatest < 0.1);
}

TEST_CASE("a checkerboard stays one at its centres") {
    auto lattice = test::lattice(8, 8);
    for (std::size_t i = 0; i < 64; ++i) lattice.conc[0][i] = (i % 8 + i / 8) % 2 == 0 ? 1.0 : -1.0;

    const auto texture = one(lattice, lattice.conc[0], 8 * 15, 8 * 15, true);

    for (std::size_t i = 0; i < 64; ++i) {
        const double value = texture.values[(i / 8 * 15 + 7) * 120 + i % 8 * 15 + 7];
        CHECK(value * lattice.conc[0][i] > 0.7);
    }
}

TEST_CASE("the texture of a torus fits together at its edges") {
    auto lattice = test::lattice(9, 7);
    for (std::size_t i = 0; i < 63; ++i) lattice.conc[0][i] = std::sin(static_cast<double>(i * i));
    auto moved = lattice;  // by 4 columns and 3 rows
    for (std::size_t row = 0; row < 7; ++row) {
        for (std::size_t column = 0; column < 9; ++column) {
            moved.conc[0][(row + 3) % 7 * 9 + (column + 4) % 9] = lattice.conc[0][row * 9 + column];
        }
    }

    const auto texture = one(lattice, lattice.conc[0], 90, 70, true);
    const auto other = one(moved, moved.conc[0], 90, 70, true);
    const auto edged = one(moved, moved.conc[0], 90, 70, false);

    std::vector<double> expected(90 * 70);
    for (std::size_t row = 0; row < 70; ++row) {
        for (std::size_t column = 0; column < 90; ++column) {
            expected[(row + 30) % 70 * 90 + (column + 40) % 90] = texture.values[row * 90 + column];
        }
    }
    CHECK(greatest_difference(other.values, expected) < 1e-9);
    CHECK(greatest_difference(edged.values, expected) > 0.01);
}

TEST_CASE("even the smallest torus has a texture") {
    const auto lattice = test::lattice(1, 2);

    const auto texture = one(lattice, lattice.conc[0], 4, 8, true);

    CHECK(*std::min_element(texture.values.begin(), texture.values.end()) >= 0.5);
    CHECK(*std::max_element(texture.values.begin(), texture.values.end()) <= 1.5);
    CHECK(texture.values[2 * 4] < texture.values[6 * 4]);
}

TEST_CASE("free cells keep their proportions in a texture of any shape") {
    const auto cells = test::cells({0, 20}, {0, 0});

    const auto texture = one(cells, {0, 1}, 110, 440);

    CHECK(texture.rows == 440);
    for (const std::size_t row : {0u, 200u, 439u}) {
        CHECK(texture.values[row * 110] < 0.5);
        CHECK(texture.values[row * 110 + 109] > 0.5);
    }
}

TEST_CASE("textures of nothing are refused") {
    CHECK_THAT(test::error_of([] { one(test::cells({}, {}), {}, 8, 8); }), Contains("0 cells"));
    CHECK_THAT(test::error_of([] { one(test::cells({0}, {0}), {1}, 0, 8); }), Contains("0 x 8"));
    CHECK_THAT(test::error_of([] { one(test::cells({0}, {0}), {1, 2}, 8, 8); }), Contains("2 values"));
    CHECK_THAT(test::error_of([] { one(test::cells({std::nan("")}, {0}), {1}, 8, 8); }), Contains("nan"));
}

TEST_CASE("an experiment says whether its lattice wraps") {
    Experiment experiment;
    CHECK_FALSE(wraps(experiment));
    experiment.prepattern = {UseSeed{3}, CreateMatrix{8, 8, Boundary::no_flux, 0, 0}};
    CHECK_FALSE(wraps(experiment));
    experiment.prepattern = {CreateMatrix{8, 8, Boundary::wrap, 0, 0}};
    CHECK(wraps(experiment));
    CreateGrid grid;
    grid.wrap = true;
    experiment.prepattern = {grid};
    CHECK(wraps(experiment));
}
