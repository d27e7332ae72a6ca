// Diffusion rates of each cell's own, impermeable cells, anisotropy, and the gradient that polarity follows.
#include "lab.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

namespace {

using namespace pelage;

const double half_root = std::sqrt(0.5);

}  // namespace

TEST_CASE("two cells exchange at the harmonic mean of their rates") {
    for (Experiment experiment : {test::grid(2, 1, false), test::matrix(2, 1, Boundary::no_flux, Stencil::moore)}) {
        experiment.phases[0].time_step = 0.5;
        Snapshot state = test::blank(experiment);
        state.conc[0] = {1, 9};
        state.diff[0] = {0.5, 0.125};  // 2 * 0.5 * 0.125 / 0.625 = 0.2

        const Snapshot end = test::after(1, experiment, state);

        CHECK(end.conc[0][0] == Approx(1 + 0.2 * 8 * 0.5));
        CHECK(end.conc[0][1] == Approx(9 - 0.2 * 8 * 0.5));
    }
}

TEST_CASE("an impermeable cell exchanges nothing and is a wall") {
    for (const Experiment& experiment : {test::grid(5, 1, false), test::matrix(5, 1, Boundary::no_flux)}) {
        Snapshot state = test::blank(experiment);
        state.conc[0] = {0, 4, 3, 1, 2};
        state.diff[0] = {0.25, 0.25, 0, 0.25, 0.25};

        const Snapshot end = test::after(200, experiment, state);

        CHECK(end.conc[0][0] == Approx(2.0));
        CHECK(end.conc[0][1] == Approx(2.0));
        CHECK(end.conc[0][2] == 3.0);
        CHECK(end.conc[0][3] == Approx(1.5));
        CHECK(end.conc[0][4] == Approx(1.5));
    }
}

TEST_CASE("cells that are all impermeable keep what they have") {
    const Experiment experiment = test::grid(3, 3, false);
    Snapshot state = test::blank(experiment);
    state.conc[0] = test::scatter(9, 0, 1, 3);
    state.diff[0].assign(9, 0.0);
    state.diff[0][4] = 0.5;

    CHECK(test::after(10, experiment, state).conc[0] == state.conc[0]);
}

TEST_CASE("anisotropic diffusion runs along polarity") {
    for (const bool along_x : {true, false}) {
        Experiment experiment = test::matrix(5, 5, Boundary::no_flux, Stencil::five_point);
        experiment.chemicals[0].anisotropic = true;
        Snapshot state = test::blank(experiment);
        state.conc[0][12] = 1.0;
        state.diff[0].assign(25, 0.125);
        (along_x ? state.polarity_x : state.polarity_y).assign(25, 1.0);

        const std::vector<double> end = test::after(1, experiment, state).conc[0];

        CHECK(end[12] == 0.75);
        CHECK(end[11] == (along_x ? 0.125 : 0.0));
        CHECK(end[13] == (along_x ? 0.125 : 0.0));
        CHECK(end[7] == (along_x ? 0.0 : 0.125));
        CHECK(end[17] == (along_x ? 0.0 : 0.125));
    }
}

TEST_CASE("anisotropic diffusion to diagonal neighbours is weakened by the cosine") {
    Experiment experiment = test::grid(3, 3, false);
    experiment.chemicals[0].anisotropic = true;
    Snapshot state = test::blank(experiment);
    state.conc[0][4] = 1.0;
    state.diff[0].assign(9, 0.0625);

    SECTION("polarity along x: diagonals at 45 degrees") {
        state.polarity_x.assign(9, 1.0);
        const std::vector<double> end = test::after(1, experiment, state).conc[0];
        for (const std::size_t corner : {0u, 2u, 6u, 8u})
            CHECK(end[corner] == Approx(0.0625 * half_root).epsilon(1e-15));
        CHECK(end[1] == 0.0);
        CHECK(end[3] == 0.0625);
    }
    SECTION("polarity along a diagonal: nothing across it") {
        state.polarity_x.assign(9, half_root);
        state.polarity_y.assign(9, half_root);
        const std::vector<double> end = test::after(1, experiment, state).conc[0];
        CHECK(end[0] == Approx(0.0625));
        CHECK(end[8] == Approx(0.0625));
        CHECK(end[2] == 0.0);
        CHECK(end[6] == 0.0);
        CHECK(end[1] == Approx(0.0625 * half_root));
    }
    SECTION("a neighbour without polarity keeps its rate") {
        state.polarity_x[4] = 1.0;
        const std::vector<double> end = test::after(1, experiment, state).conc[0];
        const double weakened = 0.0625 * half_root;
        CHECK(end[0] == Approx(2 * weakened * 0.0625 / (weakened + 0.0625)));
        CHECK(end[1] == 0.0);
        CHECK(end[3] == 0.0625);
    }
}

TEST_CASE("polarize points up the gradient, with length 1") {
    for (Experiment experiment :
         {test::grid(5, 4, false), test::matrix(5, 4, Boundary::no_flux), test::matrix(5, 4, Boundary::absorbing)}) {
        experiment.rules = {test::rule(Polarize{0})};
        Snapshot state = test::blank(experiment);
        for (std::size_t cell = 0; cell < 20; ++cell) {
            state.conc[0][cell] = 3.0 * static_cast<double>(cell % 5) + 4.0 * static_cast<double>(cell / 5);
        }

        const Snapshot end = test::after(1, experiment, state);

        CHECK(end.polarity_x[7] == Approx(0.6));
        CHECK(end.polarity_y[7] == Approx(0.8));
        for (std::size_t cell = 0; cell < 20; ++cell) {
            CHECK(std::hypot(end.polarity_x[cell], end.polarity_y[cell]) == Approx(1.0));
            CHECK(end.polarity_x[cell] > 0.0);
            CHECK(end.polarity_y[cell] > 0.0);
        }
    }
}

TEST_CASE("polarize keeps the old polarity where the field is flat") {
    Experiment experiment = test::grid(7, 3, false);
    experiment.rules = {test::rule(Polarize{0})};
    Snapshot state = test::blank(experiment);
    state.polarity_x.assign(21, -0.8);
    state.polarity_y.assign(21, 0.6);
    for (const std::size_t row : {0u, 1u, 2u}) {
        state.conc[0][row * 7 + 5] = 1e-5;  // too shallow
        state.conc[0][row * 7 + 0] = 1.0;
    }

    const Snapshot end = test::after(1, experiment, state);

    CHECK(end.polarity_x[7 + 3] == -0.8);
    CHECK(end.polarity_y[7 + 3] == 0.6);
    CHECK(end.polarity_x[7 + 4] == -0.8);
    CHECK(end.polarity_x[7 + 1] == Approx(-1.0));
    CHECK(end.polarity_y[7 + 1] == Approx(0.0).margin(1e-15));
}

TEST_CASE("the last active polarize wins, cell by cell") {
    Experiment experiment = test::grid(5, 1, false, {"A", "B"});
    experiment.rules = {
        test::rule(Polarize{0}),
        test::rule(Polarize{1}, test::compare({Quantity::column}, Comparison::greater_equal, test::number(2)))};
    Snapshot state = test::blank(experiment);
    state.conc = {{0, 1, 2, 3, 4}, {4, 3, 2, 1, 0}};

    const Snapshot end = test::after(1, experiment, state);

    CHECK(end.polarity_x == std::vector<double>{1, 1, -1, -1, -1});
}
