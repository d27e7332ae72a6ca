// Neighbour sets from the device against brute force and the reference's k-d tree: equal, not nearly.
#include "opencl/neighbours/neighbours.hpp"
#include "core/error.hpp"
#include "reference/neighbours/neighbours.hpp"
#include "support/form.hpp"
#include "support/opencl_session.hpp"
#include "verify/points.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace pelage;

namespace {

template <class T>
Neighbours by_tree(const verify::Points& points, double radius) {
    const std::vector<T> x(points.x.begin(), points.x.end());
    const std::vector<T> y(points.y.begin(), points.y.end());
    return neighbours_exact<T>(x, y, static_cast<T>(radius));
}

template <class T>
Neighbours by_force(const verify::Points& points, T radius) {
    Neighbours found{{0}, {}};
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (std::size_t j = 0; j < points.size(); ++j) {
            const T dx = static_cast<T>(points.x[j]) - static_cast<T>(points.x[i]);
            const T dy = static_cast<T>(points.y[j]) - static_cast<T>(points.y[i]);
            if (i != j && dx * dx + dy * dy < radius * radius) found.ids.push_back(static_cast<std::uint32_t>(j));
        }
        found.first.push_back(found.ids.size());
    }
    return found;
}

// As on a GPU: no vectors, many short chunks, a sort of several passes.
NeighbourTuning many_chunks() {
    NeighbourTuning tuning;
    tuning.width = 1;
    tuning.chunks = 100;
    tuning.per_chunk = 7;
    tuning.bits = 4;
    tuning.group = 8;
    return tuning;
}

void check_against_tree(const verify::Points& points) {
    const Neighbours expected = by_tree<float>(points, 3);

    const Neighbours found = opencl_neighbours(test::session(), points.x, points.y);

    CHECK(expected.ids.size() > points.size());
    CHECK(found == expected);
}

}  // namespace

TEST_CASE("neighbour sets of thousands of points equal the k-d tree's") {
    const std::size_t count = GENERATE(6000u, 20000u, 100000u);
    CAPTURE(count);

    check_against_tree(verify::hexagonal(count));
    check_against_tree(verify::jittered(count, 1));
    check_against_tree(verify::uniform(count, 2));
    check_against_tree(verify::clustered(count, 3));
    check_against_tree(verify::shuffled(verify::jittered(count, 4), 5));
}

TEST_CASE("neighbour sets of a million points equal the k-d tree's") {
    check_against_tree(verify::jittered(1000000, 6));
}

TEST_CASE("neighbour sets of sharp sizes equal brute force") {
    const std::size_t count = GENERATE(1u, 2u, 3u, 7u, 15u, 16u, 17u, 31u, 33u, 63u, 64u, 65u, 127u, 257u, 1021u);
    const double side = GENERATE(2.0, 9.0, 60.0);
    const verify::Points points = verify::crowd(count, side, static_cast<std::uint32_t>(count));
    CAPTURE(count, side);

    CHECK(opencl_neighbours(test::session(), points.x, points.y) == by_force<float>(points, 3));
    CHECK(opencl_neighbours(test::session(), points.x, points.y, 3, many_chunks()) == by_force<float>(points, 3));
}

TEST_CASE("no points have no neighbours") {
    const std::vector<double> none;

    CHECK(opencl_neighbours(test::session(), none, none) == Neighbours{{0}, {}});
}

TEST_CASE("points exactly at the radius are no neighbours") {
    const verify::Points points = verify::square_at_radius(40);

    const Neighbours at = opencl_neighbours(test::session(), points.x, points.y, 3);
    const Neighbours wider = opencl_neighbours(test::session(), points.x, points.y, 3.0001);

    CHECK(at.ids.empty());
    CHECK(wider.ids.size() == 4u * 40 * 39);
    CHECK(wider == by_force<float>(points, 3.0001f));
}

TEST_CASE("two points at one place are neighbours of each other and not of themselves") {
    const std::vector<double> x{5, -100, 5};
    const std::vector<double> y{-2, 100, -2};

    const Neighbours found = opencl_neighbours(test::session(), x, y);

    CHECK(found == Neighbours{{0, 1, 1, 2}, {2, 0}});
}

TEST_CASE("all points in one bin are each other's neighbours") {
    const verify::Points points = verify::crowd(1500, 2, 7);

    const Neighbours found = opencl_neighbours(test::session(), points.x, points.y);

    CHECK(found.ids.size() == 1500u * 1499);
    CHECK(found == by_force<float>(points, 3));
}

TEST_CASE("a line of points, along either axis") {
    const verify::Points along_x = verify::line(50000);
    const verify::Points along_y{along_x.y, along_x.x};

    check_against_tree(along_x);
    check_against_tree(along_y);
}

TEST_CASE("coordinates far from zero") {
    const double far = GENERATE(-1e4, 1e6, -3e7);
    CAPTURE(far);
    const verify::Points points = verify::moved(verify::jittered(20000, 8), far, -2 * far);

    CHECK(opencl_neighbours(test::session(), points.x, points.y) == by_tree<float>(points, 3));
}

TEST_CASE("a few points far away from many do not change their neighbours") {
    const double far = GENERATE(1e4, 1e7, 1e30, 3e38);
    CAPTURE(far);
    verify::Points points = verify::jittered(20000, 9);
    points.add(far, -far);
    points.add(-far, far);
    points.add(far, far / 2);

    CHECK(opencl_neighbours(test::session(), points.x, points.y) == by_tree<float>(points, 3));
}

TEST_CASE("more than 65,535 points in one bin") {
    const test::Optimised programs;
    verify::Points points = verify::jittered(70000, 10);
    points.add(1e30, 1e30);  // bins of this size hold all others

    CHECK(opencl_neighbours(test::session(), points.x, points.y) == by_tree<float>(points, 3));
}

TEST_CASE("a point without a finite place has no neighbours and disturbs none") {
    verify::Points points = verify::jittered(500, 11);
    points.x[10] = std::numeric_limits<double>::quiet_NaN();
    points.y[20] = std::numeric_limits<double>::infinity();
    points.x[499] = -std::numeric_limits<double>::infinity();

    const Neighbours found = opencl_neighbours(test::session(), points.x, points.y);

    CHECK(found.of(10).empty());
    CHECK(found == by_tree<float>(points, 3));
}

TEST_CASE("the shape of the work changes no neighbour set") {
    const verify::Points points = verify::shuffled(verify::clustered(9000, 12), 13);
    NeighbourTuning tuning = many_chunks();
    const Neighbours expected = by_tree<float>(points, 3);

    CHECK(opencl_neighbours(test::session(), points.x, points.y, 3, tuning) == expected);
    tuning.bits = 0;
    CHECK(opencl_neighbours(test::session(), points.x, points.y, 3, tuning) == expected);
    tuning.width = 16;
    tuning.chunks = 3;
    CHECK(opencl_neighbours(test::session(), points.x, points.y, 3, tuning) == expected);
}

TEST_CASE("tickets of bins give the same sets, and so does the sort that steps in where a bin is crowded") {
    NeighbourTuning tuning = many_chunks();
    tuning.tickets = true;
    const std::size_t count = GENERATE(1u, 2u, 64u, 257u, 9000u);
    const double side = GENERATE(0.01, 5.0, 300.0);
    CAPTURE(count, side);
    if (count * count > 1'000'000 && side < 100) return;  // nearly all pairs
    verify::Points points = verify::uniform(count, 15);
    const double extent = *std::ranges::max_element(points.x) + 1;
    for (double& x : points.x) x *= side / extent;
    for (double& y : points.y) y *= side / extent;

    CHECK(opencl_neighbours(test::session(), points.x, points.y, 3, tuning) == by_tree<float>(points, 3));
}

TEST_CASE("other radii, and double precision") {
    const double radius = GENERATE(0.25, 1.5, 4.0, 11.0);
    CAPTURE(radius);
    const verify::Points points = verify::uniform(3000, 14);

    CHECK(opencl_neighbours(test::session(), points.x, points.y, radius) ==
          by_force(points, static_cast<float>(radius)));
    CHECK(opencl_neighbours(test::session(Precision::double_), points.x, points.y, radius) == by_force(points, radius));
}

TEST_CASE("a search refuses what makes no sense") {
    const std::vector<double> one{1};
    const std::vector<double> two{1, 2};

    CHECK_THROWS_WITH(opencl_neighbours(test::session(), one, two), Catch::Contains("1 x but 2 y"));
    CHECK_THROWS_WITH(opencl_neighbours(test::session(), one, one, 0), Catch::Contains("radius"));
    CHECK_THROWS_AS(opencl_neighbours(test::session(), one, one, std::nan("")), Error);
}
