// Height and normal maps.
#include "io/relief.hpp"
#include "core/error.hpp"
#include "scratch.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <vector>

using Catch::Matchers::Contains;
using namespace pelage;

namespace {

// The direction that a pixel stands for.
double part(const DeepRgb& pixel, std::size_t axis) { return pixel[axis] / 65535.0 * 2 - 1; }

}  // namespace

TEST_CASE("a height map runs from black to white over the range, row 0 at the bottom") {
    const std::vector<double> values{0, 1, 2, 3, -5, std::nan("")};

    const auto map = height_map(values, 3, 2, {0, 2});

    CHECK(map.at(0, 1)[0] == 0);
    CHECK(map.at(1, 1)[0] == 32768);
    CHECK(map.at(2, 1)[0] == 65535);
    CHECK(map.at(0, 0)[0] == 65535);
    CHECK(map.at(1, 0)[0] == 0);
    CHECK(map.at(2, 0)[0] == 0);
    CHECK(height_map(values, 3, 2, {1, 1}).at(0, 0)[0] == 32768);
    CHECK(height_map(values, 3, 2, {}).at(0, 0)[0] == 32768);
}

TEST_CASE("a slope of one leans by 45 degrees: red against the rise to the right, green against the rise upwards") {
    std::vector<double> across;
    std::vector<double> up;
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 5; ++column) {
            across.push_back(0.5 * column);
            up.push_back(0.5 * row);
        }
    }
    const Slopes slopes{2.0, 1.0, 1.0, false};
    const auto east = normal_map_deep(across, 5, 4, slopes);
    const auto north = normal_map_deep(up, 5, 4, slopes);
    const auto flat = normal_map(std::vector<double>(20, 7.0), 5, 4, slopes);

    for (std::size_t line = 0; line < 4; ++line) {  // the edges too
        for (std::size_t column = 0; column < 5; ++column) {
            CHECK(part(east.at(column, line), 0) == Approx(-std::sqrt(0.5)).margin(1e-4));
            CHECK(part(east.at(column, line), 1) == Approx(0).margin(1e-4));
            CHECK(part(east.at(column, line), 2) == Approx(std::sqrt(0.5)).margin(1e-4));
            CHECK(part(north.at(column, line), 1) == Approx(-std::sqrt(0.5)).margin(1e-4));
            CHECK(flat.at(column, line) == Rgb{128, 128, 255});
        }
    }
    const auto wide = normal_map_deep(across, 5, 4, {2.0, 2.0, 1.0, false});
    CHECK(part(wide.at(2, 2), 0) / part(wide.at(2, 2), 2) == Approx(-0.5).margin(1e-4));
}

TEST_CASE("on a torus a map goes on over the edge") {
    constexpr std::size_t columns = 16;
    std::vector<double> wave;
    for (std::size_t i = 0; i < columns; ++i)
        wave.push_back(std::sin(0.3 + 2 * std::numbers::pi * static_cast<double>(i) / columns));
    const auto torus = normal_map_deep(wave, columns, 1, {1.0, 1.0, 1.0, true});
    const auto sheet = normal_map_deep(wave, columns, 1, {1.0, 1.0, 1.0, false});

    // The wave shifted by a cell has the map shifted by a cell.
    std::vector<double> shifted(wave.begin() + 1, wave.end());
    shifted.push_back(wave[0]);
    const auto moved = normal_map_deep(shifted, columns, 1, {1.0, 1.0, 1.0, true});
    for (std::size_t i = 0; i < columns; ++i) CHECK(moved.at(i, 0) == torus.at((i + 1) % columns, 0));
    CHECK(part(torus.at(0, 0), 0) == Approx(part(torus.at(8, 0), 0) * -1).margin(1e-4));
    CHECK(torus.at(0, 0) != sheet.at(0, 0));
    CHECK(torus.at(5, 0) == sheet.at(5, 0));
}

TEST_CASE("one row or column, and values that are not numbers, make maps too") {
    CHECK(normal_map(std::vector<double>{1.0}, 1, 1, {}).at(0, 0) == Rgb{128, 128, 255});
    CHECK(normal_map(std::vector<double>{1.0, std::nan("")}, 2, 1, {}).at(0, 0) == Rgb{128, 128, 255});
    CHECK_THAT(test::error_of([] { normal_map(std::vector<double>(5), 3, 2, {}); }), Contains("5 values"));
    CHECK_THAT(test::error_of([] { height_map({}, 0, 0, {}); }), Contains("0 values"));
}
