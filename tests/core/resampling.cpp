// What each element of a stretched lattice takes from the old ones.
#include "core/resampling.hpp"

#include <catch2/catch.hpp>

#include <numeric>

using namespace pelage;

namespace {

using Places = std::vector<std::int32_t>;

// The sampled values of one axis, in double.
std::vector<double> sampled(Interpolation interpolation, bool wrap, const std::vector<double>& old,
                            std::size_t places) {
    const Sampling axis = sampling(interpolation, wrap, old.size(), places);
    std::vector<double> values;
    for (std::size_t place = 0; place < places; ++place) {
        const auto source = [&](std::size_t i) {
            return old.at(static_cast<std::size_t>(axis.sources.at(place * (1 + axis.others) + i)));
        };
        double value = source(0);
        for (std::size_t other = 0; other < axis.others; ++other)
            value += axis.weights.at(place * axis.others + other) * (source(1 + other) - source(0));
        values.push_back(value);
    }
    return values;
}

}  // namespace

TEST_CASE("nearest: places are pixels of a stretched picture") {
    CHECK(sampling(Interpolation::nearest, false, 2, 4).nearest == Places{0, 0, 1, 1});
    CHECK(sampling(Interpolation::nearest, true, 3, 5).nearest == Places{0, 0, 1, 2, 2});
    CHECK(sampling(Interpolation::nearest, false, 4, 4).sources == Places{0, 1, 2, 3});
    CHECK(sampling(Interpolation::bicubic, false, 1, 3).nearest == Places{0, 0, 0});
}

TEST_CASE("bilinear: worked by hand, with and without a torus") {
    // Places at -1/4, 1/4, 3/4 and 5/4 of the old ones.
    CHECK(sampled(Interpolation::bilinear, false, {1, 3}, 4) == std::vector<double>{1, 1.5, 2.5, 3});
    CHECK(sampled(Interpolation::bilinear, true, {1, 3}, 4) == std::vector<double>{1.5, 1.5, 2.5, 2.5});
    CHECK(sampled(Interpolation::bilinear, false, {5}, 3) == std::vector<double>{5, 5, 5});
}

TEST_CASE("bicubic: a parabola stays one, but at the edge") {
    std::vector<double> squares;
    for (int i = 0; i < 8; ++i) squares.push_back(i * i);

    const std::vector<double> found = sampled(Interpolation::bicubic, false, squares, 12);

    for (int i = 3; i < 9; ++i) {
        const double at = (i + 0.5) * 8 / 12 - 0.5;
        CHECK(found[static_cast<std::size_t>(i)] == Approx(at * at).epsilon(1e-12));
    }
}

TEST_CASE("a matrix that keeps its size keeps its values") {
    const std::vector<double> values{3, -1, 4, 1.5};
    for (const auto way : {Interpolation::nearest, Interpolation::bilinear, Interpolation::bicubic}) {
        for (const bool wrap : {true, false}) CHECK(sampled(way, wrap, values, 4) == values);
    }
}

TEST_CASE("on a torus the mean stays what it was") {
    const std::vector<double> values{3, -1, 4, 1.5, 9};
    for (const auto way : {Interpolation::bilinear, Interpolation::bicubic}) {
        const std::vector<double> found = sampled(way, true, values, 10);
        CHECK(std::accumulate(found.begin(), found.end(), 0.0) == Approx(2 * 16.5));
    }
}
