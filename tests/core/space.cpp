// What kind of tissue an experiment makes, and of what shape.
#include "core/space.hpp"
#include "core/error.hpp"

#include <catch2/catch.hpp>

using namespace pelage;

namespace {

CreateGrid grid(Arrangement arrangement) {
    CreateGrid made;
    made.arrangement = arrangement;
    made.columns = 4;
    made.rows = 3;
    made.x = 5;
    return made;
}

Experiment cells_of(std::vector<Statement> statements) {
    Experiment experiment;
    experiment.prepattern = std::move(statements);
    experiment.stencil = Stencil::sims;
    return experiment;
}

bool free_cells(const Experiment& experiment) { return std::holds_alternative<FreeCells>(space_of(experiment)); }

}  // namespace

TEST_CASE("a matrix is a lattice of the experiment's stencil that can be expanded") {
    const auto lattice =
        std::get<Lattice>(space_of(cells_of({UseSeed{3}, CreateMatrix{4, 3, Boundary::absorbing, 0, 7}, SetCells{}})));

    CHECK(lattice.columns == 4);
    CHECK(lattice.rows == 3);
    CHECK(lattice.y == 7);
    CHECK(lattice.boundary == Boundary::absorbing);
    CHECK(lattice.stencil == Stencil::sims);
    CHECK(lattice.arithmetic == Arithmetic::fused);
    CHECK(lattice.expandable);
}

TEST_CASE("a square grid is a lattice of the published arithmetic") {
    CreateGrid wrapped = grid(Arrangement::sqr_grid);
    wrapped.wrap = true;
    const auto lattice = std::get<Lattice>(space_of(cells_of({grid(Arrangement::sqr_grid)})));

    CHECK(lattice.columns == 4);
    CHECK(lattice.rows == 3);
    CHECK(lattice.x == 5);
    CHECK(lattice.boundary == Boundary::no_flux);
    CHECK(lattice.stencil == Stencil::moore);
    CHECK(lattice.arithmetic == Arithmetic::published);
    CHECK_FALSE(lattice.expandable);
    CHECK(std::get<Lattice>(space_of(cells_of({wrapped}))).boundary == Boundary::wrap);
}

TEST_CASE("everything else is free cells") {
    CreateGrid jittered = grid(Arrangement::sqr_grid);
    jittered.deviation = 0.1;

    CHECK(free_cells(cells_of({})));
    CHECK(free_cells(cells_of({jittered})));
    CHECK(free_cells(cells_of({grid(Arrangement::hex_grid)})));
    CHECK(free_cells(cells_of({grid(Arrangement::sqr_grid), CreateCell{}})));
    CHECK(free_cells(cells_of({CreateShape{{"Aa"}, 0, 0, false}})));
    for (const Action& action : {Action(Divide{}), Action(Move{})}) {
        Experiment leaving = cells_of({grid(Arrangement::sqr_grid)});
        leaving.rules.push_back({});
        leaving.rules.back().action = action;
        CHECK(free_cells(leaving));
    }
}

TEST_CASE("a lattice is given another size, free cells are not") {
    for (Experiment lattice :
         {cells_of({CreateMatrix{4, 3, Boundary::wrap, 0, 0}}), cells_of({grid(Arrangement::sqr_grid)})}) {
        resize_lattice(lattice, 9, 8);
        CHECK(std::get<Lattice>(space_of(lattice)).columns == 9);
        CHECK(std::get<Lattice>(space_of(lattice)).rows == 8);
    }
    Experiment cells = cells_of({CreateCell{}});
    CHECK_THROWS_AS(resize_lattice(cells, 9, 8), Error);
}
