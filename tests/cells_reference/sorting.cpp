// The authors' spatial sorting: the order of its matrix, what its window finds, and what it misses.
#include "reference/neighbours/spatial_sorting.hpp"

#include "cells_reference/clouds.hpp"
#include "core/error.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <numeric>

using namespace pelage;
using reference::SortedMatrix;

namespace {

template <class T>
bool in_order(const SortedMatrix<T>& matrix, const test::Cloud<T>& cloud) {
    const std::vector<std::uint32_t> ids = matrix.order();
    const std::size_t side = matrix.side();
    for (std::size_t place = 0; place < ids.size(); ++place) {
        const bool right = place % side + 1 < side && place + 1 < ids.size();
        if (right && cloud.x[ids[place]] > cloud.x[ids[place + 1]]) return false;
        if (place + side < ids.size() && cloud.y[ids[place]] > cloud.y[ids[place + side]]) return false;
    }
    return true;
}

template <class T>
bool every_id_once(const SortedMatrix<T>& matrix, std::size_t cells) {
    std::vector<std::uint32_t> ids = matrix.order();
    std::ranges::sort(ids);
    std::vector<std::uint32_t> all(cells);
    std::iota(all.begin(), all.end(), 0u);
    return ids == all;
}

}  // namespace

TEMPLATE_TEST_CASE("rows are sorted by x and columns by y", "", float, double) {
    using T = TestType;
    const std::size_t cells = GENERATE(1u, 2u, 3u, 4u, 5u, 8u, 9u, 10u, 97u, 100u, 1021u);
    test::Cloud<T> cloud = test::scattered<T>(cells, T(60), T(60), 1);
    SortedMatrix<T> matrix{SpatialSorting{}};

    matrix.update(cloud.x, cloud.y);

    CHECK(matrix.side() * matrix.side() >= cells);
    CHECK((matrix.side() - 1) * (matrix.side() - 1) < cells);
    CHECK(every_id_once(matrix, cells));
    CHECK(in_order(matrix, cloud));
}

TEST_CASE("a matrix small enough for its window finds every neighbour, those exactly at the radius too") {
    const std::size_t window = GENERATE(8u, 24u, 48u, 80u, 120u);
    const auto reach = static_cast<std::size_t>(window < 24    ? 1
                                                : window < 48  ? 2
                                                : window < 80  ? 3
                                                : window < 120 ? 4
                                                               : 5);
    test::Cloud<float> cloud = test::scattered<float>((reach + 1) * (reach + 1) - 2, 7.0f, 7.0f, 2);
    cloud.add(0, 0);
    cloud.add(3, 0);
    SortedMatrix<float> matrix(SpatialSorting{window, 0});

    matrix.update(cloud.x, cloud.y);

    const Neighbours expected = test::by_force<float>(cloud.x, cloud.y, 3, true);
    REQUIRE(expected != test::by_force<float>(cloud.x, cloud.y, 3));
    CHECK(matrix.neighbours() == expected);
    CHECK(matrix.statistics().neighbours_missed == 0);
}

TEST_CASE("what spatial sorting finds are neighbours, and what it misses is counted") {
    const std::size_t window = GENERATE(8u, 24u, 48u);
    const test::Cloud<float> cloud = test::scattered<float>(900, 54.0f, 54.0f, 3);
    SortedMatrix<float> matrix(SpatialSorting{window, 0});
    matrix.update(cloud.x, cloud.y);
    const Neighbours exact = test::by_force<float>(cloud.x, cloud.y, 3);

    const Neighbours found = matrix.neighbours();
    const SearchStatistics statistics = matrix.statistics();

    std::size_t missed = 0, cells = 0, most = 0, wrong = 0;
    for (std::size_t i = 0; i < cloud.size(); ++i) {
        std::size_t of_cell = 0;
        for (const std::uint32_t j : exact.of(i)) of_cell += std::ranges::binary_search(found.of(i), j) ? 0 : 1;
        for (const std::uint32_t j : found.of(i)) wrong += std::ranges::binary_search(exact.of(i), j) ? 0 : 1;
        missed += of_cell;
        cells += of_cell == 0 ? 0 : 1;
        most = std::max(most, of_cell);
    }
    CHECK(wrong == 0);  // no two of these points are exactly 3 apart
    REQUIRE(missed > 0);
    CHECK(statistics.neighbours_missed == missed);
    CHECK(statistics.cells_with_misses == cells);
    CHECK(statistics.most_missed == most);
    CHECK(statistics.neighbours_exact == exact.ids.size());
    CHECK(statistics.cells == 900);
    CHECK(statistics.iterations == 1);
    CHECK(statistics.miss_rate() == Approx(static_cast<double>(missed) / static_cast<double>(exact.ids.size())));
}

TEST_CASE("a wider window misses less") {
    const test::Cloud<double> cloud = test::scattered<double>(2000, 80.0, 80.0, 4);
    double before = 1;

    for (const std::size_t window : {8u, 24u, 48u, 80u, 120u}) {
        SortedMatrix<double> matrix(SpatialSorting{window, 0});
        matrix.update(cloud.x, cloud.y);
        const double rate = matrix.statistics().miss_rate();
        CHECK(rate < before);
        before = rate;
    }

    CHECK(before < 0.01);
}

TEST_CASE("children take the places behind, and a wider side re-cuts the sequence") {
    test::Cloud<float> cloud = test::scattered<float>(98, 30.0f, 30.0f, 5);
    SortedMatrix<float> matrix{SpatialSorting{}};
    matrix.update(cloud.x, cloud.y);
    REQUIRE(matrix.side() == 10);

    for (int i = 0; i < 7; ++i) {
        const auto parent = static_cast<std::size_t>(10 * i);
        cloud.add(cloud.x[parent] + 0.6f, cloud.y[parent] - 0.8f);
        matrix.update(cloud.x, cloud.y);
        CHECK(every_id_once(matrix, cloud.size()));
        CHECK(in_order(matrix, cloud));
    }

    CHECK(matrix.side() == 11);
    CHECK(matrix.statistics().cells == 105);
}

TEST_CASE("a limited number of rounds goes on where the last update ended") {
    const test::Cloud<float> cloud = test::scattered<float>(400, 36.0f, 36.0f, 6);
    SortedMatrix<float> whole{SpatialSorting{}};
    SortedMatrix<float> piecewise(SpatialSorting{48, 1});
    whole.update(cloud.x, cloud.y);

    piecewise.update(cloud.x, cloud.y);
    const bool after_one = in_order(piecewise, cloud);
    for (int i = 0; i < 400; ++i) piecewise.update(cloud.x, cloud.y);

    CHECK_FALSE(after_one);
    CHECK(piecewise.order() == whole.order());
    CHECK(piecewise.neighbours() == whole.neighbours());
}

TEST_CASE("statistics of several iterations add up") {
    SearchStatistics sum;
    sum += {1, 100, 600, 6, 5, 2};
    sum += {1, 110, 650, 4, 4, 1};

    CHECK(sum.iterations == 2);
    CHECK(sum.cells == 210);
    CHECK(sum.most_missed == 2);
    CHECK(sum.miss_rate() == Approx(10.0 / 1250.0));
    CHECK(SearchStatistics().miss_rate() == 0);
}

TEST_CASE("a window that is not offered is refused") {
    const std::size_t window = GENERATE(0u, 1u, 7u, 9u, 47u, 49u, 168u);

    CHECK_THROWS_AS(SortedMatrix<float>(SpatialSorting{window, 0}), Error);
}
