// Diffusion against analysis: mass, decay of a single mode, order of convergence, symmetry.
#include "lab.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <string>

namespace {

using namespace pelage;

const std::vector<Stencil> stencils{Stencil::nine_point, Stencil::sims, Stencil::moore, Stencil::five_point};

// Minus the Laplacian's eigenvalue for a mode that turns by p a column and q a row.
double eigenvalue(Stencil stencil, double p, double q) {
    const double edges = 2 * std::cos(p) + 2 * std::cos(q);
    const double corners = 4 * std::cos(p) * std::cos(q);
    switch (stencil) {
        case Stencil::nine_point:
            return -(4 * edges + corners - 20) / 6;
        case Stencil::sims:
            return -(0.2 * edges + 0.05 * corners - 1);
        case Stencil::moore:
            return -(edges + corners - 8);
        case Stencil::five_point:
            return -(edges - 4);
        default:
            break;  // of one's own, and of volumes: reference/volume.cpp
    }
    return 0.0;
}

// A cosine along both directions; on a torus whole periods, else half periods about the edges.
Snapshot mode(const Experiment& experiment, double p, double q, double shift) {
    Snapshot state = test::blank(experiment);
    for (std::size_t row = 0; row < state.rows; ++row) {
        for (std::size_t column = 0; column < state.columns; ++column) {
            state.conc[0][row * state.columns + column] =
                std::cos(p * (static_cast<double>(column) + shift)) * std::cos(q * (static_cast<double>(row) + shift));
        }
    }
    return state;
}

void check_mass(Experiment experiment, double rate, bool own_rates) {
    experiment.phases[0].time_step = 0.1;
    Snapshot state = test::blank(experiment);
    const std::size_t cells = state.cells();
    state.conc[0] = test::scatter(cells, 0.0, 10.0, 7);
    state.diff[0] = own_rates ? test::scatter(cells, 0.0, rate, 11) : std::vector<double>(cells, rate);

    const Snapshot end = test::after(300, experiment, state);

    CHECK(test::spread(end.conc[0]) < 0.9 * test::spread(state.conc[0]));
    CHECK(test::sum(end.conc[0]) == Approx(test::sum(state.conc[0])).epsilon(1e-13));
}

}  // namespace

TEST_CASE("diffusion without bounds conserves mass to rounding") {
    for (const bool own_rates : {false, true}) {
        for (const Boundary boundary : {Boundary::no_flux, Boundary::wrap}) {
            for (const Stencil stencil : stencils) check_mass(test::matrix(13, 7, boundary, stencil), 0.5, own_rates);
        }
        for (const bool wrap : {false, true}) check_mass(test::grid(13, 7, wrap), 0.5, own_rates);
    }
}

TEST_CASE("an absorbing edge loses mass") {
    const Experiment experiment = test::matrix(9, 9, Boundary::absorbing);
    Snapshot state = test::blank(experiment);
    state.conc[0].assign(81, 1.0);
    state.diff[0].assign(81, 0.1);

    const Snapshot end = test::after(10, experiment, state);

    CHECK(test::sum(end.conc[0]) < 80.0);
    CHECK(end.conc[0][0] < end.conc[0][4]);
    CHECK(end.conc[0][4] < end.conc[0][40]);
}

TEST_CASE("a cosine mode decays by exactly its discrete factor") {
    constexpr double pi = std::numbers::pi;
    for (const Stencil stencil : stencils) {
        for (const bool wrap : {false, true}) {
            Experiment experiment = test::matrix(12, 20, wrap ? Boundary::wrap : Boundary::no_flux, stencil);
            experiment.phases[0].time_step = 0.25;
            const double p = wrap ? 2 * pi * 2 / 12 : pi * 3 / 12;
            const double q = wrap ? 2 * pi * 3 / 20 : pi * 5 / 20;
            Snapshot state = mode(experiment, p, q, wrap ? 0.0 : 0.5);
            state.diff[0].assign(state.cells(), 0.1);
            REQUIRE(test::spread(state.conc[0]) > 1.0);

            const Snapshot end = test::after(40, experiment, state);

            const double factor = std::pow(1 - 0.1 * 0.25 * eigenvalue(stencil, p, q), 40);
            REQUIRE(factor > 1e-8);
            for (std::size_t cell = 0; cell < state.cells(); ++cell) {
                CHECK(end.conc[0][cell] == Approx(factor * state.conc[0][cell]).margin(1e-14));
            }
        }
    }
}

TEST_CASE("the error falls with the first power of the time step") {
    const double p = 2 * std::numbers::pi / 16;
    const auto error = [&](std::uint64_t steps) {
        Experiment experiment = test::matrix(16, 1, Boundary::wrap);
        experiment.phases[0].time_step = 8.0 / static_cast<double>(steps);
        Snapshot state = mode(experiment, p, 0.0, 0.0);
        state.diff[0].assign(16, 0.5);
        const double exact = std::exp(-0.5 * 8.0 * eigenvalue(Stencil::nine_point, p, 0.0));
        return std::abs(test::after(steps, experiment, state).conc[0][0] - exact);
    };

    const double order = std::log2(error(32) / error(64));

    CHECK(error(64) > 1e-6);
    CHECK(order == Approx(1.0).margin(0.05));
}

TEST_CASE("the error falls with the second power of the spacing") {
    for (const Stencil stencil : {Stencil::nine_point, Stencil::five_point}) {
        // One step from cos(2 pi x) on n x n cells of the unit square gives the discrete Laplacian itself.
        const auto error = [&](std::size_t n) {
            const double p = 2 * std::numbers::pi / static_cast<double>(n);
            Experiment experiment = test::matrix(n, n, Boundary::wrap, stencil);
            experiment.phases[0].time_step = 1e-4;
            Snapshot state = mode(experiment, p, p, 0.0);
            state.diff[0].assign(n * n, static_cast<double>(n * n));
            const double change = test::after(1, experiment, state).conc[0][0] - state.conc[0][0];
            const double exact = -8 * std::numbers::pi * std::numbers::pi;
            return std::abs(change / 1e-4 - exact);
        };

        const double order = std::log2(error(16) / error(32));

        CHECK(error(32) > 1e-3);
        CHECK(order == Approx(2.0).margin(0.05));
    }
}

TEST_CASE("a shift around the torus commutes with the iteration") {
    for (Experiment experiment :
         {test::matrix(11, 5, Boundary::wrap, Stencil::nine_point, {"U", "V"}), test::grid(11, 5, true, {"U", "V"})}) {
        experiment.phases[0].time_step = 0.01;
        experiment.rules = {
            test::rule(React{model_named("turing"), {0, 1}, test::number(1), {test::number(16), test::number(12)}})};
        Snapshot state = test::blank(experiment);
        state.conc = {test::scatter(55, 3, 5, 1), test::scatter(55, 3, 5, 2)};
        state.diff = {std::vector<double>(55, 5.0), std::vector<double>(55, 1.0)};
        const auto shifted = [](Snapshot from) {
            Snapshot to = from;
            for (std::size_t cell = 0; cell < 55; ++cell) {
                const std::size_t there = (cell / 11 + 2) % 5 * 11 + (cell % 11 + 3) % 11;
                for (std::size_t c : {0u, 1u}) to.conc[c][there] = from.conc[c][cell];
            }
            return to;
        };

        const Snapshot first = shifted(test::after(50, experiment, state, Precision::single_));
        const Snapshot second = test::after(50, experiment, shifted(state), Precision::single_);

        CHECK(test::spread(first.conc[0]) > 0.01);
        CHECK(test::same(first, second));
    }
}
