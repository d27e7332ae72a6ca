// The authors' spatial sorting on the device against the reference's: the same order, sets and misses.
#include "opencl/neighbours/spatial_sorting.hpp"
#include "core/error.hpp"
#include "core/prepattern.hpp"
#include "core/searching.hpp"
#include "opencl/neighbours/neighbours.hpp"
#include "reference/cells/tissue.hpp"
#include "reference/neighbours/spatial_sorting.hpp"
#include "support/free_cells.hpp"
#include "support/opencl_session.hpp"
#include "verify/points.hpp"

#include <catch2/catch.hpp>

#include <numeric>

using namespace pelage;

namespace {

// A matrix on the device fed with points, the first `count` of them.
class Matrix {
public:
    explicit Matrix(SpatialSorting settings) : matrix_(test::session(), settings) {}

    void update(const verify::Points& points, std::size_t count) {
        const std::size_t pitch = points.size() + 32;
        std::vector<float> planes(2 * pitch);
        std::vector<cl_int> ids(pitch);
        std::iota(ids.begin(), ids.end(), 0);
        for (std::size_t i = 0; i < count; ++i) {
            planes[i] = static_cast<float>(points.x[i]);
            planes[pitch + i] = static_cast<float>(points.y[i]);
        }
        const cl::Buffer positions = test::session().buffer(planes.size() * sizeof(float), "positions");
        ids_ = test::session().buffer(ids.size() * sizeof(cl_int), "ids");
        const cl::CommandQueue& queue = test::session().queue();
        queue.enqueueWriteBuffer(positions, CL_TRUE, 0, planes.size() * sizeof(float), planes.data());
        queue.enqueueWriteBuffer(ids_, CL_TRUE, 0, ids.size() * sizeof(cl_int), ids.data());
        matrix_.update(positions, static_cast<int>(pitch), static_cast<int>(count));
        lists_.reserve(test::session(), count, 200);
        queue.enqueueFillBuffer(lists_.longest, cl_int{0}, 0, sizeof(cl_int));
        matrix_.find(ids_, lists_);
    }

    std::vector<std::uint32_t> order() const {
        const std::vector<cl_int> order = matrix_.order();
        return {order.begin(), order.end()};
    }
    Neighbours neighbours() const {
        return read_lists(test::session(), ids_, lists_, static_cast<std::size_t>(matrix_.cells()));
    }
    SearchStatistics statistics() const { return matrix_.statistics(ids_, lists_); }

private:
    DeviceMatrix matrix_;
    DeviceLists lists_;
    cl::Buffer ids_;
};

void check_equal(const verify::Points& points, SpatialSorting settings) {
    reference::SortedMatrix<float> expected(settings);
    Matrix found(settings);
    const std::vector<float> x(points.x.begin(), points.x.end());
    const std::vector<float> y(points.y.begin(), points.y.end());

    for (const std::size_t count : {points.size() / 3, points.size() / 2, points.size()}) {  // the tissue grows
        expected.update(std::span(x).first(count), std::span(y).first(count));
        found.update(points, count);
        CAPTURE(count);
        CHECK(found.order() == expected.order());
        CHECK(found.neighbours() == expected.neighbours());
        const SearchStatistics misses = expected.statistics();
        CHECK(found.statistics().neighbours_exact == misses.neighbours_exact);
        CHECK(found.statistics().neighbours_missed == misses.neighbours_missed);
        CHECK(found.statistics().cells_with_misses == misses.cells_with_misses);
        CHECK(found.statistics().most_missed == misses.most_missed);
    }
}

}  // namespace

TEST_CASE("spatial sorting on the device orders and finds as the reference does") {
    const std::size_t window = GENERATE(8u, 24u, 48u, 80u, 120u);
    const std::size_t rounds = GENERATE(0u, 1u, 11u);
    CAPTURE(window, rounds);

    check_equal(verify::shuffled(verify::jittered(1021, 21), 22), {window, rounds});
}

TEST_CASE("spatial sorting of sharp sizes, coinciding and far points") {
    const std::size_t count = GENERATE(3u, 4u, 5u, 9u, 10u, 16u, 17u, 65u);

    check_equal(verify::crowd(count, 8, 23), {});
    check_equal(verify::moved(verify::square_at_radius(9), -4e5, 3e5), {});
    check_equal(verify::Points{{1, 1, 1, 1, 1, 1}, {2, 2, 2, 2, 2, 2}}, {});
}

TEST_CASE("spatial sorting misses neighbours of a scattered tissue, and says how many") {
    Matrix matrix({});
    const verify::Points points = verify::uniform(4000, 24);

    matrix.update(points, points.size());

    CHECK(matrix.statistics().iterations == 1);
    CHECK(matrix.statistics().cells == 4000);
    CHECK(matrix.statistics().neighbours_missed > 0);
    CHECK(matrix.statistics().miss_rate() < 0.5);
}

TEST_CASE("a tissue grown with spatial sorting equals the reference's, bit for bit") {
    const auto experiment = test::experiment(R"(
define chemical U limit 4.5
define chemical V
define domain packed
use seed 31
use chemical U conc 4 dev 1 diff 0.1
use chemical V conc 4 dev 1 diff 0.02
create hex_grid 12 11 dev 0.2
rule always react U V scale 0.01 turing alpha 16 beta 12
rule from 10 probability 0.01 divide direction 0 dev 180
)");
    CellsOptions options;
    options.search = NeighbourSearch::spatial_sorting;
    options.sorting.rounds = GENERATE(0u, 1u);
    options.list_capacity = 0;
    const Snapshot initial = initial_state(*experiment);
    const auto expected =
        make_reference_cells(experiment, initial, Precision::single_, options.search, options.sorting);
    const auto found = test::on_device(experiment, options);

    test::check_equal_runs(*expected, *found, 120, 20);

    REQUIRE(search_statistics(*found));
    CHECK(found->cells() > 2 * initial.cells());
    CHECK(search_statistics(*found)->neighbours_exact == search_statistics(*expected)->neighbours_exact);
    CHECK(search_statistics(*found)->neighbours_missed == search_statistics(*expected)->neighbours_missed);
    CHECK(search_statistics(*found)->cells == search_statistics(*expected)->cells);
}

TEST_CASE("an exact search has no misses to count, a window that is not offered is refused") {
    const auto experiment = test::experiment("define chemical A\ncreate cell 0 0\n");
    CellsOptions options;

    CHECK_FALSE(search_statistics(*test::on_device(experiment, options)));

    options.search = NeighbourSearch::spatial_sorting;
    options.sorting.window = 49;
    CHECK_THROWS_WITH(test::on_device(experiment, options),
                      Catch::Contains("49") && Catch::Contains("8, 24, 48, 80, 120"));
}
