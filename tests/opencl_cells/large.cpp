// Populations far past the first buffers.
#include "many_cells.hpp"
#include "support/form.hpp"
#include "support/free_cells.hpp"
#include "support/opencl_session.hpp"

#include <catch2/catch.hpp>

using namespace pelage;

TEST_CASE("two cells become 70,000 without a lost or a doubled cell") {
    const test::Optimised programs;
    test::check_growth_from_two(70'000);  // ids beyond 16 bits
}

TEST_CASE("a million static cells run") {
    const auto tissue = test::on_device(test::experiment(R"(
define chemical U
define chemical V
define domain 4000 4000
use seed 1
use chemical U conc 4 dev 1 diff 0.1
use chemical V conc 4 dev 1 diff 0.02
create hex_grid 1000 1000
rule always react U V scale 0.01 turing alpha 16 beta 12
)"));
    const Snapshot start = tissue->read();

    tissue->advance(10);

    const Snapshot end = tissue->read();
    CHECK(end.cells() == 1000000);
    CHECK(end.neighbours[500500] == 6);
    CHECK(end.conc != start.conc);
    CHECK_FALSE(tissue->non_finite());
}
