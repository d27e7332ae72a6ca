// The test in small that comes before a run: a piece of any state, stepped on both sides.
#include "verify/self_test.hpp"

#include "core/prepattern.hpp"
#include "language/parse.hpp"
#include "reference/backend.hpp"
#include "verify/cases.hpp"
#include "verify/cases_cells.hpp"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace pelage;
using namespace pelage::verify;

TEST_CASE("a small piece of a lattice comes from its middle and is whole") {
    const Experiment experiment = lattice_case("rules/quantities/fused").experiment({67, 31});
    const Snapshot whole = initial_state(experiment);

    const Snapshot piece = small_piece(whole);

    REQUIRE(piece.columns == 37);
    REQUIRE(piece.rows == 13);
    REQUIRE(piece.cells() == 37 * 13);
    REQUIRE(piece.conc[0][0] == whole.conc[0][9 * 67 + 15]);
    const auto tissue = reference_backend(Precision::single_)->make_tissue(experiment, piece);
    REQUIRE(tissue->read().x == piece.x);
    REQUIRE(tissue->read().y == piece.y);
}

TEST_CASE("a lattice smaller than the piece is taken whole") {
    const Experiment experiment = lattice_case("diffusion/published/wrap").experiment({5, 3});

    REQUIRE(small_piece(initial_state(experiment)).cells() == 15);
}

TEST_CASE("this device passes, on lattices that change their rules and grow, and on free cells") {
    for (const char* name : {"rules/phases/fused", "growth/plain/no-flux", "rates/polarized/published/wrap"}) {
        CAPTURE(name);
        const Experiment experiment = lattice_case(name).experiment({60, 40});
        CHECK(self_test({}, experiment, initial_state(experiment), 80).empty());
    }
    const CellCase& cells = *std::ranges::find(cell_cases(), "cells/move", &CellCase::name);
    const Experiment experiment = parse_experiment(cells.text(), cells.name, ".");
    CHECK(self_test({}, experiment, initial_state(experiment), 80).empty());
}

TEST_CASE("a device told to be fast may differ a little") {
    const Experiment experiment = lattice_case("diffusion/nine-point/wrap").experiment({60, 40});
    OpenclOptions options;
    options.fast = true;

    CHECK(self_test(options, experiment, initial_state(experiment), 10).empty());
}
