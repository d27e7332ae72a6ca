// How tissues start: geometry, order of draws, lattices told from free cells.
#include "core/prepattern.hpp"

#include "core/error.hpp"
#include "core/published_random.hpp"
#include "core/seed.hpp"
#include "core/support_experiments.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <set>

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

TEST_CASE("what is drawn is drawn in float in any precision, what is not keeps its double in a run in double") {
    CreateGrid jittered = grid(Arrangement::hex_grid, 2, 2);
    jittered.deviation = 0.25;
    CreateGrid placed = grid(Arrangement::hex_circle, 3, 0);
    placed.x = 0.3;
    const auto state = [&](Precision precision) {
        return initial_state(
            with({UseChemical{0, Spread{0.3, 0.0}, Spread{0.7, 0.1}}, UseChemical{1, Spread{0.3, 0.1}, Spread{0.1, 0}},
                  UsePolarity{Spread{30, 0}}, CreateCell{0.1, 0.2, false}, CreateShape{{"A"}, 0.1, 0.3, false},
                  UsePolarity{Spread{30, 10}}, jittered, UsePolarity{}, placed,
                  SetCells{1, 1, SetConcentration{1, {0.6, 0}}}, SetCells{1, 1, SetRate{1, {0.6, 0}}},
                  SetCells{1, 1, SetPolarity{Spread{60, 0}}}}),
            precision);
    };
    const Snapshot single = state(Precision::single_);
    const Snapshot full = state(Precision::double_);
    const auto rounded = [](double value) { return static_cast<double>(static_cast<float>(value)); };

    CHECK(full.conc[0] == std::vector<double>(full.cells(), 0.3));
    CHECK(single.conc[0] == std::vector<double>(full.cells(), rounded(0.3)));
    CHECK(full.diff[0] == single.diff[0]);
    CHECK(full.conc[1][0] == single.conc[1][0]);
    CHECK(full.conc[1][1] == 0.6);
    CHECK(full.diff[1][0] == 0.1);
    CHECK(full.diff[1][1] == 0.6);
    CHECK(full.x[0] == 0.1);
    CHECK(full.y[0] == 0.2);
    CHECK(full.x[1] == 0.1 - 1.0);
    CHECK(full.y[1] == 0.3 + 1.0);
    CHECK(full.polarity_x[0] == std::cos(std::numbers::pi / 6));
    CHECK(full.polarity_x[1] == std::cos(std::numbers::pi / 3));
    REQUIRE(full.cells() == single.cells());
    for (std::size_t cell = 2; cell < 6; ++cell) {  // jittered, their polarity drawn
        CHECK(full.x[cell] == single.x[cell]);
        CHECK(full.y[cell] == single.y[cell]);
        CHECK(full.polarity_x[cell] == single.polarity_x[cell]);
    }
    for (std::size_t cell = 6; cell < full.cells(); ++cell) {
        const double row = std::round(full.y[cell] / 1.7321);
        CHECK(full.y[cell] == row * 1.7321);
        CHECK(std::abs(full.x[cell] - single.x[cell]) < 1e-6);
    }
    for (const auto* column : {&single.x, &single.y, &single.polarity_x, &single.polarity_y, &single.conc[1]}) {
        for (const double value : *column) CHECK(value == rounded(value));
    }
}

TEST_CASE("two clocks give two seeds, and one experiment one") {
    std::set<std::int64_t> seeds;
    for (int i = 0; i < 1000; ++i) seeds.insert(seed_from_clock());
    CHECK(seeds.size() == 1000);
    CHECK(*seeds.begin() > 0);
    CHECK(*seeds.rbegin() < std::int64_t{1} << 53);

    const auto start = [](std::vector<Statement> statements) {
        statements.insert(statements.end(), {UseChemical{0, Spread{4, 2}, {}}, grid(Arrangement::sqr_grid, 5, 1)});
        return initial_state(with(std::move(statements))).conc[0];
    };
    CHECK(start({UseSeed{0}}) != start({UseSeed{0}}));
    CHECK(start({UseSeed{1}}) != start({UseSeed{4294967296}}));
    CHECK(start({UseSeed{1}}) != start({UseSeed{4294967297}}));

    Experiment clocked = with({UseSeed{0}});
    CHECK(seeded_by_clock(clocked));
    settle_seed(clocked, 7);
    CHECK(clocked.run_seed() == 7);
    settle_seed(clocked, 8);
    CHECK(clocked.run_seed() == 7);
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
