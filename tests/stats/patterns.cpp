// Patterns with known answers: stripes, discs, noise.
#include "core/error.hpp"
#include "core/philox.hpp"
#include "stats/course.hpp"
#include "stats/dimension.hpp"
#include "stats/statistics.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <vector>

using namespace pelage;
using namespace pelage::stats;

namespace {

struct Pattern {
    std::size_t columns = 0, rows = 0;
    std::vector<double> values;

    template <class F>
    Pattern(std::size_t width, std::size_t height, F value) : columns(width), rows(height) {
        for (std::size_t row = 0; row < rows; ++row) {
            for (std::size_t column = 0; column < columns; ++column)
                values.push_back(value(static_cast<double>(column), static_cast<double>(row)));
        }
    }
    Grid grid(bool wrap = true) const { return {values, columns, rows, wrap}; }
};

double noise(std::size_t n) { return unit_uniform<double>(counted_words(n, 0, 0, 0, 5)[0]); }

Pattern stripes(double length, double degrees, std::size_t width = 128, std::size_t height = 96) {
    const double angle = degrees * std::numbers::pi / 180;
    return {width, height, [=](double x, double y) {
                return 3 + std::sin(2 * std::numbers::pi * (x * std::cos(angle) + y * std::sin(angle)) / length);
            }};
}

}  // namespace

TEST_CASE("stripes: their wavelength, their direction, and that they are stripes") {
    for (const double length : {6.0, 9.5, 14.0, 23.0}) {
        for (const double degrees : {0.0, 30.0, 90.0, 135.0, 170.0}) {
            for (const bool wrap : {false, true}) {
                INFO(length << " " << degrees << " " << wrap);
                const Statistics found = statistics_of(stripes(length, degrees).grid(wrap));
                CHECK(found.waves.wavelength == Approx(length).epsilon(length > 20 ? 0.1 : 0.05));
                const double off = std::fabs(found.waves.direction - degrees);
                CHECK(std::min(off, 180 - off) < 4);
                CHECK(found.waves.anisotropy > 0.85);
                CHECK(found.mean == Approx(3).margin(0.15));
                CHECK(found.features.coverage == Approx(0.5).margin(0.07));
            }
        }
    }
    CHECK(orientation_order(stripes(12, 40).grid(false)) > 0.97);
}

TEST_CASE("the shortest waves, and waves along rows and columns exactly") {
    const Pattern board(64, 64, [](double x, double y) { return std::fmod(x + y, 2.0); });
    CHECK(waves_of(board.grid()).wavelength == Approx(std::sqrt(2.0)));
    CHECK(waves_of(board.grid(false)).wavelength == Approx(std::sqrt(2.0)).epsilon(0.02));
    for (const bool wrap : {false, true}) {
        CHECK(waves_of(stripes(16, 0, 128, 128).grid(wrap)).direction == Approx(0).margin(0.01));
        CHECK(waves_of(stripes(16, 90, 128, 128).grid(wrap)).direction == Approx(90).margin(0.01));
    }
}

TEST_CASE("numbers that are very large or very small are measured like others") {
    const Statistics plain = statistics_of(stripes(12, 30).grid());
    for (const double scale : {0x1p1000, 0x1p-1000}) {
        Pattern scaled = stripes(12, 30);
        for (double& value : scaled.values) value *= scale;
        const Statistics found = statistics_of(scaled.grid());
        CHECK(found.mean == Approx(plain.mean * scale));
        CHECK(found.deviation == Approx(plain.deviation * scale));
        CHECK(found.maximum == plain.maximum * scale);
        CHECK(found.waves.wavelength == plain.waves.wavelength);
        CHECK(found.waves.anisotropy == plain.waves.anisotropy);
        CHECK(found.features.count == plain.features.count);
    }
}

TEST_CASE("discs: how many, how large, how far apart") {
    const Pattern discs(120, 90, [](double x, double y) {
        const double dx = std::fmod(x, 15.0) - 7, dy = std::fmod(y, 15.0) - 7;
        return dx * dx + dy * dy < 16.5 ? 2.0 : -1.0;
    });
    const Statistics found = statistics_of(discs.grid());
    CHECK(found.features.count == 48);
    CHECK(found.features.size == 57.0 - 4.0 * 2.0);  // 49 places within the root of 16.5
    CHECK(found.features.coverage == Approx(48 * 49.0 / (120 * 90)));
    CHECK(found.waves.wavelength == Approx(15).epsilon(0.02));
    CHECK(found.waves.anisotropy < 0.05);
    CHECK(found.orientation_order < 0.02);
    CHECK(found.minimum == -1.0);
    CHECK(found.maximum == 2.0);
}

TEST_CASE("a piece across an edge is one on a torus, and two where edges end it") {
    const Pattern band(20, 10, [](double x, double) { return x < 3 || x > 16 ? 1.0 : 0.0; });
    CHECK(features_of(band.grid(true)).count == 1);
    CHECK(features_of(band.grid(false)).count == 2);
    const Pattern corner(20, 10, [](double x, double y) { return x + y == 5 ? 1.0 : 0.0; });
    CHECK(features_of(corner.grid()).count == 6);  // they touch at corners alone
}

TEST_CASE("noise has no direction and no length of its own, a flat field has nothing") {
    const Pattern random(128, 128, [](double x, double y) { return noise(static_cast<std::size_t>(x + 128 * y)); });
    const Statistics found = statistics_of(random.grid());
    CHECK(found.mean == Approx(0.5).margin(0.01));
    CHECK(found.deviation == Approx(std::sqrt(1.0 / 12)).epsilon(0.02));
    CHECK(found.waves.anisotropy < 0.1);
    CHECK(found.orientation_order < 0.05);
    CHECK_FALSE(uniform(found));

    const Statistics flat = statistics_of(Pattern(16, 8, [](double, double) { return 0.7; }).grid());
    CHECK(uniform(flat));
    CHECK(flat.features.count == 0);
    CHECK(flat.waves.wavelength == 0.0);
    CHECK(flat.orientation_order == 0.0);
    const Statistics one = statistics_of(Pattern(1, 1, [](double, double) { return 4.0; }).grid());
    CHECK(one.mean == 4.0);
}

TEST_CASE("what is no pattern is refused") {
    const std::vector<double> six(6, 1.0), broken{1.0, std::nan("")};
    CHECK_THROWS_WITH(statistics_of({six, 4, 2, false}), "6 values are no pattern of 4 x 2");
    CHECK_THROWS_WITH(statistics_of({six, 0, 2, false}), Catch::Contains("no pattern"));
    CHECK_THROWS_WITH(statistics_of({broken, 2, 1, false}), Catch::Contains("finite"));
}

TEST_CASE("what patterns do in time") {
    const auto verdict = [](auto&& value) {
        Course course;
        for (int t = 0; t < 8; ++t)
            course.show(Pattern(40, 30, [&](double x, double y) { return value(x, y, t); }).grid());
        return course.verdict();
    };
    const double k = 2 * std::numbers::pi / 10;
    CHECK(verdict([](double, double, int) { return 0.4; }) == Verdict::uniform);
    CHECK(verdict([&](double x, double, int) { return std::sin(k * x); }) == Verdict::stationary);
    CHECK(verdict([&](double x, double, int t) { return std::sin(k * x - 0.7 * t); }) == Verdict::moving);
    CHECK(verdict([&](double x, double, int t) { return std::sin(k * x) * (2 + std::sin(0.8 * t)); }) ==
          Verdict::oscillating);
    CHECK(verdict([](double, double, int t) { return 1 + 0.5 * std::sin(0.8 * t); }) == Verdict::oscillating);
    for (const double size : {1e160, 1.7e308}) {
        CHECK(verdict([&](double x, double, int t) { return size * std::sin(k * x - 0.7 * t); }) == Verdict::moving);
        CHECK(verdict([&](double x, double, int) { return size * std::sin(k * x); }) == Verdict::stationary);
        CHECK(verdict([&](double x, double, int t) { return (t < 2 ? 1.0 : size) * std::sin(k * x - 0.7 * t); }) ==
              Verdict::moving);
    }
    Course faint;
    for (int t = 0; t < 4; ++t)
        faint.show(Pattern(40, 30, [&](double x, double) { return 1e-30 * std::sin(k * x); }).grid());
    CHECK(faint.verdict() == Verdict::stationary);
    CHECK(faint.verdict(0.5) == Verdict::uniform);
    const Pattern one = stripes(10, 0), other = stripes(10, 0, 128, 96);
    CHECK(change(one.grid(), other.grid()) == 0.0);
    CHECK(change(one.grid(), stripes(11, 0).grid()) > 0.1);
    const auto large = [&](double shift) {
        return Pattern(40, 30, [=](double x, double) { return 1.7e308 * std::sin(k * x + shift); });
    };
    CHECK(change(large(0).grid(), large(1).grid()) == Approx(0.3).margin(0.1));
}

TEST_CASE("the dimension of what is known: filled, a line, a sieve, a carpet, nothing") {
    const auto of = [](std::size_t side, const auto& holds) {
        const auto cell = [&](double x, double y) {
            return holds(static_cast<unsigned>(x), static_cast<unsigned>(y)) ? 1.0 : 0.0;
        };
        return dimension_of(Pattern(side + 5, side + 3, cell).grid(false));
    };
    CHECK(of(256, [](unsigned x, unsigned y) { return x < 256 && y < 256; }) == Approx(2.0));
    CHECK(of(256, [](unsigned x, unsigned y) { return x == y + 1 && x < 256; }) == Approx(1.0).margin(0.01));
    CHECK(of(256, [](unsigned x, unsigned y) { return x < 256 && y < 256 && (x & y) == 0; }) == Approx(std::log2(3.0)));
    const auto carpet = [](unsigned x, unsigned y) {
        if (x >= 243 || y >= 243) return false;
        for (; x > 0 || y > 0; x /= 3, y /= 3) {
            if (x % 3 == 1 && y % 3 == 1) return false;
        }
        return true;
    };
    CHECK(of(243, carpet) == Approx(std::log(8.0) / std::log(3.0)).margin(0.06));
    CHECK(of(30, [](unsigned, unsigned) { return false; }) == 0.0);
    CHECK(of(30, [](unsigned x, unsigned y) { return x < 15 && y < 15; }) == 0.0);
}
