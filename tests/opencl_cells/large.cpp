// Populations far past the first buffers.
#include "core/prepattern.hpp"
#include "support/free_cells.hpp"
#include "support/opencl_session.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace pelage;

TEST_CASE("two cells become 200,000 without a lost or a doubled cell") {
    const auto tissue = test::on_device(test::experiment(R"(
define chemical A
define domain 3000 3000
define division_limit 9
use chemical A conc 1 diff 0.1
create cell 0 0
create cell 2 0
rule probability 0.2 divide direction 0 dev 180
)"));

    std::size_t before = 2;
    while (tissue->cells() < 200000) {
        tissue->advance(20);
        REQUIRE(tissue->cells() >= before);
        before = tissue->cells();
    }

    const Snapshot state = tissue->read();  // reading checks that every id is there once
    CHECK(state.cells() == tissue->cells());
    // Ids are given in order of birth, and A is neither made nor lost but by division, which copies it.
    CHECK(std::is_sorted(state.birth.begin(), state.birth.end()));
    CHECK(std::ranges::all_of(state.conc[0], [](double value) { return value == 1; }));
    CHECK(std::ranges::all_of(state.x, [](double x) { return std::abs(x) <= 1500; }));
    CHECK(std::ranges::all_of(state.fixed, [](std::uint8_t fixed) { return fixed == 0; }));
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
