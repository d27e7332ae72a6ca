// What may not change a result on the device, and what must hold whatever the result.
#include "core/error.hpp"
#include "core/prepattern.hpp"
#include "support/free_cells.hpp"
#include "support/opencl_session.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace pelage;

namespace {

const char* const growing = R"(
define chemical U limit 4.5
define chemical V
define division_limit 7
define domain packed
define time_step 0.1
use seed 9
use chemical U conc 4 dev 1 diff 0.40
use chemical V conc 4 dev 1 diff 0.02
create hex_grid 9 8
rule always react U V scale 0.05 turing alpha 16 beta 12
rule from 20 probability 0.005 divide direction 0 dev 180
)";

// One iteration a launch, unless asked otherwise.
CellsOptions alone() {
    CellsOptions options;
    options.together = false;
    return options;
}

Snapshot after(std::uint64_t iterations, const CellsOptions& options = alone()) {
    const auto tissue = test::on_device(test::experiment(growing), options);
    tissue->advance(iterations);
    return tissue->read();
}

std::unique_ptr<Tissue> with_options(const OpenclOptions& changed, const CellsOptions& options = alone()) {
    const auto experiment = test::experiment(growing);
    const auto session = std::make_shared<const Session>(test::session().info(), changed);
    return make_opencl_cells(session, experiment, initial_state(*experiment), options);
}

}  // namespace

TEST_CASE("free cells: skin, batch and list capacity change no bit") {
    const Snapshot expected = after(250);
    const Snapshot start = after(0);
    CellsOptions options = alone();

    CHECK(expected.cells() > 2 * start.cells());
    for (const double skin : {0.0, 0.001, 1.5, 4.0}) {
        options.skin = skin;
        CHECK(test::difference(expected, after(250, options)) == test::no_difference);
    }
    options = alone();
    for (const std::size_t batch : {1u, 2u, 7u, 100u}) {
        options.batch = batch;
        CHECK(test::difference(expected, after(250, options)) == test::no_difference);
    }
    options = alone();
    options.list_capacity = 0;  // the least is taken, and grows
    options.skin = 2.5;
    CHECK(test::difference(expected, after(250, options)) == test::no_difference);
}

TEST_CASE("free cells: the shape of the work changes no bit") {
    const Snapshot expected = after(200);
    const std::size_t width = GENERATE(1u, 2u, 4u, 8u, 16u);
    CAPTURE(width);
    OpenclOptions options;
    options.width = width;
    options.work_group = 3 * width;
    CellsOptions as_on_a_gpu = alone();
    as_on_a_gpu.tuning = NeighbourTuning{1, 50, 3, 4, 16};

    const auto alike = with_options(options);
    alike->advance(200);
    const auto otherwise = with_options(options, as_on_a_gpu);
    otherwise->advance(200);

    CHECK(test::difference(expected, alike->read()) == test::no_difference);
    CHECK(test::difference(expected, otherwise->read()) == test::no_difference);
}

TEST_CASE("free cells: advancing in pieces changes no bit") {
    const Snapshot expected = after(100);
    const auto tissue = test::on_device(test::experiment(growing));

    for (const std::uint64_t piece : {1u, 1u, 2u, 17u, 30u, 48u, 1u}) tissue->advance(piece);

    CHECK(test::difference(expected, tissue->read()) == test::no_difference);
}

TEST_CASE("free cells: a run resumed from its state changes no bit") {
    const Snapshot expected = after(160);
    const Snapshot halfway = after(77);

    const auto tissue = test::on_device(test::experiment(growing));
    tissue->advance(3);
    tissue->write(halfway);
    tissue->advance(160 - 77);

    CHECK(test::difference(expected, tissue->read()) == test::no_difference);
}

TEST_CASE("free cells: what is written is read back") {
    const auto experiment = test::experiment(growing);
    Snapshot state = initial_state(*experiment);
    state.iteration = 4294967290;
    for (std::size_t i = 0; i < state.cells(); ++i) {
        const auto value = static_cast<double>(i);
        state.polarity_x[i] = value / 64;
        state.polarity_y[i] = -value / 32;
        state.birth[i] = i < 7 ? 4294967290u : static_cast<std::uint32_t>(i) - 7;
        state.neighbours[i] = static_cast<std::int32_t>(i % 9);
        state.fixed[i] = i % 2;
        state.conc[1][i] = value / 8;
        state.diff[0][i] = value / 1024;
    }
    state.mirrors = {{1, 2}};
    const auto tissue = test::on_device(experiment);

    tissue->write(state);

    CHECK(test::difference(state, tissue->read()) == test::no_difference);
}

TEST_CASE("free cells: fewer and more cells can be written than there were") {
    const Snapshot few = after(0);
    const Snapshot many = after(250);
    REQUIRE(many.cells() > few.cells());
    const auto tissue = test::on_device(test::experiment(growing));

    tissue->write(many);
    CHECK(test::difference(many, tissue->read()) == test::no_difference);
    tissue->write(few);
    CHECK(test::difference(few, tissue->read()) == test::no_difference);
    tissue->advance(250);
    CHECK(test::difference(many, tissue->read()) == test::no_difference);
}

TEST_CASE("free cells: diffusion keeps the total amount, with rates of their own too") {
    const auto experiment = test::experiment(
        "define chemical A\ndefine chemical B\nuse seed 2\n"
        "use chemical A conc 3 dev 3 diff 0.1\nuse chemical B conc 3 dev 3 diff 0.06 dev 0.05\n"
        "create hex_grid 31 29 dev 0.2\n");
    const auto tissue = test::on_device(experiment, {}, Precision::double_);
    const auto total = [&](std::size_t chemical) {
        const Snapshot state = tissue->read();
        double sum = 0;
        for (const double value : state.conc[chemical]) sum += value;
        return sum;
    };
    const double a = total(0);
    const double b = total(1);

    tissue->advance(200);

    CHECK(total(0) == Approx(a).epsilon(1e-12));
    CHECK(total(1) == Approx(b).epsilon(1e-12));
}

TEST_CASE("free cells: impermeable cells exchange nothing") {
    const auto experiment = test::experiment(
        "define chemical A\nuse chemical A conc 5 diff 0.1\ncreate cell 0 0\n"
        "use chemical A conc 1 diff 0\ncreate cell 2 0\n");
    const auto tissue = test::on_device(experiment);

    tissue->advance(10);

    CHECK(tissue->read().conc[0] == std::vector<double>{5, 1});
}

TEST_CASE("free cells: two overlapping cells separate symmetrically") {
    const auto experiment = test::experiment("define chemical A\ncreate cell -0.25 0.5\ncreate cell 0.25 -0.5\n");
    const auto tissue = test::on_device(experiment);

    tissue->advance(100);

    const Snapshot state = tissue->read();
    CHECK(state.x[0] == -state.x[1]);
    CHECK(state.y[0] == -state.y[1]);
    CHECK(std::hypot(state.x[0] - state.x[1], state.y[0] - state.y[1]) == Approx(2).epsilon(1e-5));
}

TEST_CASE("free cells: a move by a power of two changes no concentration bit") {
    const std::string lines = "define chemical A\nuse seed 4\nuse chemical A conc 3 dev 1 diff 0.1\n";
    const auto here = test::on_device(test::experiment(lines + "create hex_grid 20 20 fixed\n"));
    Snapshot moved = here->read();
    // On a coarse raster, so that the moved places are exact.
    for (double& x : moved.x) x = std::round(x * 64) / 64;
    for (double& y : moved.y) y = std::round(y * 64) / 64;
    here->write(moved);
    for (double& x : moved.x) x += 256;
    for (double& y : moved.y) y -= 128;
    const auto there = test::on_device(test::experiment(lines + "create hex_grid 20 20 fixed\n"));
    there->write(moved);

    here->advance(50);
    there->advance(50);

    CHECK(here->read().conc == there->read().conc);
}

TEST_CASE("free cells: the first value that is not finite is found") {
    const auto experiment = test::experiment(growing);
    const auto tissue = test::on_device(experiment);
    CHECK_FALSE(tissue->non_finite());
    tissue->advance(130);
    CHECK_FALSE(tissue->non_finite());
    Snapshot state = tissue->read();
    state.conc[1][70] = std::numeric_limits<double>::infinity();
    state.conc[1][50] = std::numeric_limits<double>::quiet_NaN();
    state.conc[1][90] = state.conc[1][50];

    tissue->write(state);

    REQUIRE(tissue->non_finite());
    CHECK(tissue->non_finite()->chemical == 1);
    CHECK(tissue->non_finite()->cell == 50);
}

TEST_CASE("free cells: a NaN is found in fast arithmetic too, whose compiler may take all for finite") {
    const auto experiment = test::experiment(growing);
    OpenclOptions fast;
    fast.fast = true;
    const auto tissue = with_options(fast);
    Snapshot state = tissue->read();
    for (const double value : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        CHECK_FALSE(tissue->non_finite());
        state.conc[1][50] = value;
        tissue->write(state);
        REQUIRE(tissue->non_finite());
        CHECK(tissue->non_finite()->chemical == 1);
        CHECK(tissue->non_finite()->cell == 50);
        state.conc[1][50] = 1;
        tissue->write(state);
    }
}

TEST_CASE("free cells: what cannot run is refused") {
    const auto lattice = test::experiment("define chemical A\ncreate sqr_grid 4 4\n");
    CHECK_THROWS_AS(test::on_device(lattice), Error);

    CellsOptions options;
    options.skin = -1;
    CHECK_THROWS_WITH(test::on_device(test::experiment(growing), options), Catch::Contains("skin"));

    std::string lines = growing;
    for (int i = 0; i < 32; ++i) lines += "rule if AGE == 900 divide\n";
    CHECK_THROWS_WITH(test::on_device(test::experiment(lines)), Catch::Contains("33 divide rules"));
}

TEST_CASE("free cells: memory that does not suffice is said before it is used") {
    DeviceInfo small = test::session().info();
    small.memory = 200000;
    small.max_allocation = 150000;
    const auto session = std::make_shared<const Session>(small, OpenclOptions{});
    const auto experiment = test::experiment(growing);
    const auto tissue = make_opencl_cells(session, experiment, initial_state(*experiment));

    CHECK_THROWS_WITH(tissue->advance(4000), Catch::Contains("cells") && Catch::Contains("MiB"));
}
