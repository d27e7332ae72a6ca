// How tissues start: geometry, order of draws, lattices told from free cells.
#include "core/prepattern.hpp"

#include "core/error.hpp"
#include "core/support_experiments.hpp"

#include <catch2/catch.hpp>

using namespace pelage;
using Catch::Matchers::Contains;

namespace {

Experiment with(std::vector<Statement> statements) {
    Experiment experiment = test::turing_matrix(2, 2);
    experiment.prepattern = std::move(statements);
    return experiment;
}

CreateGrid grid(Arrangement arrangement, std::size_t columns, std::size_t rows) {
    return {arrangement, columns, rows, 0, 0, 0, false, false};
}

}  // namespace

TEST_CASE("a square grid is centred with spacing 2, bottom row first") {
    const Snapshot state = initial_state(with({grid(Arrangement::sqr_grid, 3, 2)}));

    CHECK(state.columns == 3);
    CHECK(state.rows == 2);
    CHECK(state.x == std::vector<double>{-2, 0, 2, -2, 0, 2});
    CHECK(state.y == std::vector<double>{-1, -1, -1, 1, 1, 1});
}

TEST_CASE("each cell draws conc then diff of each chemical in order") {
    PublishedRandom random(9);

    const Snapshot state =
        initial_state(with({UseSeed{9}, UseChemical{1, Spread{4, 2}, Spread{1, 0.5}},
                            UseChemical{0, Spread{3, 1}, Spread{2, 0}}, grid(Arrangement::sqr_grid, 2, 1)}));

    for (std::size_t cell = 0; cell < 2; ++cell) {
        CHECK(state.conc[0][cell] == random.deviate(3, 1));
        CHECK(state.diff[0][cell] == 2.0);
        CHECK(state.conc[1][cell] == random.deviate(4, 2));
        CHECK(state.diff[1][cell] == random.deviate(1, 0.5f));
    }
}

TEST_CASE("jitter draws y first and lies below the centre") {
    CreateGrid jittered = grid(Arrangement::hex_grid, 2, 2);
    jittered.deviation = 0.25;
    PublishedRandom random(1);

    const Snapshot state = initial_state(with({jittered}));

    const float y = random.range(-0.5f, 0.0f);
    const float x = random.range(-0.5f, 0.0f);
    CHECK(state.x[0] == -1.0f + x);
    CHECK(state.y[0] == static_cast<float>(-1.0 * 1.7321 + 0.866) + y);
    CHECK_FALSE(state.lattice());
}

TEST_CASE("mirror pairs follow the letters of a shape") {
    const Snapshot forward = initial_state(with({CreateShape{{"ABoba"}, 0, 0, false}}));
    const Snapshot reversed = initial_state(with({CreateShape{{"aaAA"}, 0, 0, false}}));
    using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

    CHECK(forward.cells() == 5);
    CHECK(forward.mirrors == Pairs{{0, 4}, {1, 3}});
    CHECK(reversed.mirrors == Pairs{{2, 1}, {3, 0}});
}

TEST_CASE("cells are counted without creating them") {
    for (const Arrangement arrangement : {Arrangement::sqr_circle, Arrangement::hex_circle}) {
        const Experiment experiment = with({grid(arrangement, 17, 0)});

        CHECK(count_cells(experiment) == initial_state(experiment).cells());
        CHECK(count_cells(experiment) > 100);
    }
    CHECK(count_cells(with({CreateShape{{"A.a", "o"}, 0, 0, false}, CreateCell{}})) == 4);
}

TEST_CASE("set names existing cells only") {
    const SetCells set{2, 9, SetConcentration{0, {1, 0}}};

    CHECK_THROWS_WITH(initial_state(with({grid(Arrangement::sqr_grid, 3, 3), set})), Contains("cells 0 to 8 exist"));
}

TEST_CASE("a picture must have the lattice's shape") {
    Experiment experiment = with({CreateMatrix{3, 2, Boundary::wrap, 0, 0}});
    experiment.chemicals[0].initial = std::make_shared<Field>(Field{2, 3, {1, 2, 3, 4, 5, 6}});

    CHECK_THROWS_WITH(initial_state(experiment), Contains("is 2 x 3; the lattice is 3 x 2"));
}
