// The k-d tree's neighbour sets against the comparison of all pairs: equal, never nearly.
#include "reference/neighbours/neighbours.hpp"

#include "cells_reference/clouds.hpp"
#include "core/error.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <random>

using namespace pelage;
using reference::NeighbourLists;

namespace {

template <class T>
Neighbours exact(const test::Cloud<T>& cloud, T radius = T(3)) {
    return neighbours_exact<T>(cloud.x, cloud.y, radius);
}

template <class T>
Neighbours forced(const test::Cloud<T>& cloud, T radius = T(3)) {
    return test::by_force<T>(cloud.x, cloud.y, radius);
}

// The candidates that pass the strict test.
template <class T>
Neighbours filtered(const NeighbourLists<T>& lists, const test::Cloud<T>& cloud) {
    Neighbours found;
    found.first.push_back(0);
    for (std::size_t i = 0; i < cloud.size(); ++i) {
        for (const std::uint32_t j : lists.candidates().of(i)) {
            const T dx = cloud.x[j] - cloud.x[i];
            const T dy = cloud.y[j] - cloud.y[i];
            if (dx * dx + dy * dy < T(9)) found.ids.push_back(j);
        }
        found.first.push_back(found.ids.size());
    }
    return found;
}

}  // namespace

TEMPLATE_TEST_CASE("neighbours of tissue-like clouds", "", float, double) {
    using T = TestType;
    const T far = GENERATE(T(0), T(-700), T(12345));
    const test::Cloud<T> cloud = GENERATE(test::hexagonal<T>(31, 40, T(0), 1), test::hexagonal<T>(37, 29, T(0.4), 2),
                                          test::scattered<T>(1500, T(70), T(75), 3), test::clustered<T>(9, 120, 4));

    const test::Cloud<T> placed = test::moved(cloud, far, -far);
    const Neighbours found = exact(placed);

    REQUIRE(found.ids.size() > 4 * cloud.size());
    CHECK(found == forced(placed));
}

TEMPLATE_TEST_CASE("neighbours where points share places", "", float, double) {
    using T = TestType;
    test::Cloud<T> crowd;
    for (int i = 0; i < 300; ++i) crowd.add(T(-2.5), T(7));
    test::Cloud<T> pairs = test::scattered<T>(200, T(40), T(40), 5);
    for (std::size_t i = 0; i < 200; ++i) pairs.add(pairs.x[i], pairs.y[i]);

    CHECK(exact(crowd).ids.size() == 300 * 299);
    CHECK(exact(crowd) == forced(crowd));
    CHECK(exact(pairs) == forced(pairs));
}

TEMPLATE_TEST_CASE("neighbours along a line, and none of points too few", "", float, double) {
    using T = TestType;
    test::Cloud<T> line;
    for (int i = 0; i < 500; ++i) line.add(static_cast<T>(i % 2 == 0 ? i : 501 - i), T(0));
    test::Cloud<T> one;
    one.add(T(1), T(2));
    test::Cloud<T> two = one;
    two.add(T(2), T(2));

    CHECK(exact(line) == forced(line));
    CHECK(exact(test::Cloud<T>()) == Neighbours{{0}, {}});
    CHECK(exact(one) == Neighbours{{0, 0}, {}});
    CHECK(exact(two) == Neighbours{{0, 1, 2}, {1, 0}});
}

TEMPLATE_TEST_CASE("a point exactly at the radius is no neighbour", "", float, double) {
    using T = TestType;
    const T inside = std::nextafter(T(3), T(0));
    test::Cloud<T> cloud;
    cloud.add(T(0), T(0));
    for (const T d : {T(3), T(-3), inside, -inside}) {
        cloud.add(d, T(0));
        cloud.add(T(0), d);
    }
    test::Cloud<T> grid;  // every edge neighbour exactly at the radius
    for (int i = 0; i < 400; ++i) grid.add(static_cast<T>(3 * (i % 20)), static_cast<T>(3 * (i / 20)));

    const Neighbours found = exact(cloud);

    const auto centre = found.of(0);
    CHECK(std::vector<std::uint32_t>(centre.begin(), centre.end()) == std::vector<std::uint32_t>{5, 6, 7, 8});
    CHECK(found == forced(cloud));
    CHECK(exact(grid).ids.empty());
    CHECK(exact(grid, T(3.0001)) == forced(grid, T(3.0001)));
}

TEMPLATE_TEST_CASE("the test in T decides where distances nearly equal the radius", "", float, double) {
    using T = TestType;
    std::mt19937 random(8);
    test::Cloud<T> cloud;  // pairs at 3 +- a few units in the last place, far enough from each other
    for (int i = 0; i < 1000; ++i) {
        const T angle = static_cast<T>(random() % 6283) / T(1000);
        const T d =
            T(3) * (T(1) + static_cast<T>(static_cast<int>(random() % 9) - 4) * std::numeric_limits<T>::epsilon());
        const T x = static_cast<T>(20 * (i % 32)), y = static_cast<T>(20 * (i / 32));
        cloud.add(x, y);
        cloud.add(x + d * std::cos(angle), y + d * std::sin(angle));
    }

    const Neighbours found = exact(cloud);

    REQUIRE(found.ids.size() > 100);
    REQUIRE(found.ids.size() < 1900);
    CHECK(found == forced(cloud));
}

TEMPLATE_TEST_CASE("neighbours of points far out and nowhere", "", float, double) {
    using T = TestType;
    const T infinity = std::numeric_limits<T>::infinity();
    test::Cloud<T> cloud;
    for (const T x : {T(1e30), T(-1e30), T(1e6), T(1e6), std::numeric_limits<T>::quiet_NaN(), infinity, -infinity}) {
        cloud.add(x, T(5));
        cloud.add(T(5), x);
        cloud.add(x, x);
    }

    const Neighbours found = exact(cloud);

    CHECK(found == forced(cloud));
    CHECK(found.of(6).size() == 1);  // its twin at (1e6, 5)
    CHECK(found.of(12).empty());     // not a number
    CHECK_THROWS_AS(neighbours_exact<T>(cloud.x, std::span<const T>(), T(3)), Error);
}

TEMPLATE_TEST_CASE("lists that are kept find the same as lists made anew", "", float, double) {
    using T = TestType;
    std::mt19937 random(9);
    const auto step = [&](T size) { return size * (static_cast<T>(random() % 2001) / T(1000) - T(1)); };
    test::Cloud<T> cloud = test::scattered<T>(400, T(40), T(40), 10);
    NeighbourLists<T> lists(T(3), GENERATE(T(0.01), T(0.4), T(5)));
    std::size_t wrong = 0;

    for (int iteration = 0; iteration < 120; ++iteration) {
        for (std::size_t i = 0; i < cloud.size(); ++i) {
            // Most drift, some jump, a few run off.
            const T size = i % 50 == 7 ? T(1) : i == 11 && iteration > 60 ? T(30) : T(0.03);
            cloud.x[i] += step(size);
            cloud.y[i] += step(size);
        }
        const auto born = static_cast<std::size_t>(iteration % 10 == 9 ? 150 : iteration % 3);
        for (std::size_t i = 0; i < born; ++i) cloud.add(cloud.x[i * 2] + step(T(1)), cloud.y[i * 2] + step(T(1)));
        if (iteration == 80) cloud = test::scattered<T>(300, T(30), T(30), 11);
        if (iteration == 90) cloud.x[5] = std::numeric_limits<T>::quiet_NaN();
        lists.update(cloud.x, cloud.y);
        if (filtered(lists, cloud) != forced(cloud)) ++wrong;
    }

    CHECK(wrong == 0);
}
