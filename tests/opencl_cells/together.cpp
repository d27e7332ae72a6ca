// Many iterations of a small tissue in one launch: the same bits, whatever the work-group, and when that is chosen.
#include "opencl/cells/together.hpp"
#include "core/prepattern.hpp"
#include "support/free_cells.hpp"
#include "support/opencl_session.hpp"
#include "verify/cases_cells.hpp"

#include <catch2/catch.hpp>

#include <string>

using namespace pelage;

namespace {

// Starts crowded, so that cells stray, and grows from 40 cells past every size that room was made for at first.
const char* const crowded = R"(
define chemical U limit 4.5
define chemical V anisotropic
define division_limit 8
define domain packed
define time_step 0.1
use seed 11
use polarity 20 dev 90
use chemical U conc 4 dev 1 diff 0.30 dev 0.05
use chemical V conc 4 dev 1 diff 0.02
create hex_grid 5 8 dev 0.9
rule always react U V scale 0.05 turing alpha 16 beta 12
rule always polarize V conc
rule from 10 probability 0.015 divide direction 0 dev 180
rule from 40 probability 0.004 divide direction 90
rule every 9 always move 0.5 dev 0.25
)";

std::unique_ptr<Tissue> on_device(const std::shared_ptr<const Experiment>& experiment, const OpenclOptions& options,
                                  CellsOptions cells = {}) {
    cells.together = true;
    const auto session = std::make_shared<const Session>(test::session().info(), options);
    return make_opencl_cells(session, experiment, initial_state(*experiment), cells);
}

}  // namespace

TEST_CASE("a small tissue in one work-group: its shape changes no bit") {
    const auto [width, group, precision] =
        GENERATE(table<std::size_t, std::size_t, Precision>({{4, 5, Precision::single_}, {16, 2, Precision::double_}}));
    CAPTURE(width, group);
    const auto experiment = test::experiment(crowded);
    OpenclOptions options;
    options.width = width;
    options.work_group = group;
    options.precision = precision;
    const auto expected = test::on_reference(experiment, precision);
    const auto found = on_device(experiment, options);

    test::check_equal_runs(*expected, *found, 200, 40);

    CHECK(found->cells() > 200);
}

TEST_CASE("a small tissue in one work-group: skin and lists that are too short change no bit") {
    const auto experiment = test::experiment(crowded);
    CellsOptions options;
    options.skin = GENERATE(0.0, 0.01, 0.3, 2.5);
    options.list_capacity = 0;  // the least is taken, and grows
    CAPTURE(options.skin);
    const auto expected = test::on_reference(experiment);
    const auto found = on_device(experiment, {}, options);

    test::check_equal_runs(*expected, *found, 150, 50);
}

TEST_CASE("a small tissue in one work-group: mirror pairs, also where pairs share cells") {
    const std::size_t group = GENERATE(1u, 7u);
    const auto experiment = test::experiment(verify::cell_tissue +
                                             "rule probability 0.1 change A diff 0.01\nrule probability 0.02 divide\n");
    Snapshot initial = initial_state(*experiment);
    initial.mirrors = {{0, 12}, {1, 11}, {11, 2}, {100, 5}, {5, 12}, {7, 8}};
    OpenclOptions options;
    options.work_group = group;
    const auto expected = test::on_reference(experiment);
    const auto found = on_device(experiment, options);
    expected->write(initial);
    found->write(initial);

    test::check_equal_runs(*expected, *found, 40, 8);
}

TEST_CASE("a tissue that outgrows one work-group goes on without a seam") {
    const auto experiment = test::experiment(
        "define chemical U\nuse seed 2\nuse chemical U conc 4 dev 2 diff 0.1\ndefine domain 300 300\n"
        "create hex_grid 45 43 dev 0.2\nrule probability 0.03 divide direction 0 dev 180\n");
    const auto expected = test::on_reference(experiment);
    const auto found = test::on_device(experiment);
    const auto small = [&] {
        return cells_step_together(test::session().info(), Path::automatic, {}, found->cells(), true);
    };
    REQUIRE(small());

    test::check_equal_runs(*expected, *found, 8, 2);

    CHECK_FALSE(small());
}

TEST_CASE("one work-group takes small tissues, and the larger ones of those that grow") {
    const auto together = [](std::size_t cells, bool grows, Path path = Path::automatic,
                             const CellsOptions& options = {}) {
        return cells_step_together(test::session().info(), path, options, cells, grows);
    };
    CHECK(together(1, false));
    CHECK(together(600, false));
    CHECK(together(1500, true));
    CHECK_FALSE(together(6000, false));
    CHECK_FALSE(together(20'000, true));

    CHECK_FALSE(together(1, true, Path::step));
    CHECK(together(20'000, false, Path::shared));
    CellsOptions approximate;
    approximate.search = NeighbourSearch::spatial_sorting;
    CHECK_FALSE(together(1, false, Path::automatic, approximate));
}
