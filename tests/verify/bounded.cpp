// What a device may be off by that need not round quotients correctly: values a little, nothing else.
#include "verify/bounded.hpp"

#include "core/prepattern.hpp"
#include "verify/cases.hpp"

#include <catch2/catch.hpp>

#include <limits>

using namespace pelage;
using namespace pelage::verify;

namespace {

Snapshot state() {
    Snapshot made;
    made.columns = 20;
    made.rows = 10;
    made.conc = {std::vector<double>(200, 0.5), std::vector<double>(200, 64.0)};
    made.diff = made.conc;
    made.mappings = {};
    made.x = made.y = made.polarity_x = made.polarity_y = std::vector<double>(200, 1.0);
    made.birth.assign(200, 3);
    made.neighbours.assign(200, 8);
    made.fixed.assign(200, 0);
    return made;
}

bool within(const Snapshot& found) {
    Tally tally;
    add(tally, state(), found, Precision::single_, "here");
    return within_bound(tally);
}

}  // namespace

TEST_CASE("values may be off by the bound, of large ones by as much of themselves") {
    Snapshot found = state();
    found.conc[0][17] += 0.9 * division_bound;
    found.conc[1][18] += 60 * division_bound;

    REQUIRE(within(state()));
    REQUIRE(within(found));

    found.conc[0][17] += 0.2 * division_bound;
    REQUIRE_FALSE(within(found));
}

TEST_CASE("what is counted may not be off, nor may a value be lost") {
    Snapshot born = state();
    born.birth[5] = 4;
    Snapshot counted = state();
    counted.neighbours[199] = 7;
    Snapshot shrunk = state();
    shrunk.conc[1].pop_back();
    Snapshot lost = state();
    lost.conc[0][0] = std::numeric_limits<double>::quiet_NaN();

    REQUIRE_FALSE(within(born));
    REQUIRE_FALSE(within(counted));
    REQUIRE_FALSE(within(shrunk));
    REQUIRE_FALSE(within(lost));
}

TEST_CASE("one iteration is taken from each state, on both sides") {
    const Experiment experiment = lattice_case("reaction/fused").experiment({21, 13});
    Place place(select_device(), 1, false, false);
    Snapshot later = initial_state(experiment);
    later.iteration = 7;

    const Tally tally = single_iterations(experiment, {initial_state(experiment), later}, place, {});

    REQUIRE(tally.cells_compared == 2 * 21 * 13);
    REQUIRE(within_bound(tally));
}
