// Diffusion in volumes: worked by hand, its laws, and what it has in common with lattices.
#include "core/stability.hpp"
#include "lab.hpp"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

using namespace pelage;

namespace {

constexpr std::array volume_boundaries{Boundary::no_flux, Boundary::wrap, Boundary::absorbing};
constexpr std::array volume_stencils{Stencil::seven_point, Stencil::twenty_seven_point};

// What a one in cell `from` of 3 x 3 x 3 zeros makes in one iteration at rate 1.
std::vector<double> spread_from(std::size_t from, Boundary boundary, Stencil stencil) {
    const Experiment experiment = test::volume(3, 3, 3, boundary, stencil);
    Snapshot state = test::blank(experiment);
    state.conc[0][from] = 1.0;
    state.diff[0].assign(27, 1.0);
    return test::after(1, experiment, state).conc[0];
}

// The same for a start that each cell's place gives.
template <class Start>
Snapshot started(const Experiment& experiment, double rate, Start start) {
    Snapshot state = test::blank(experiment);
    for (std::size_t cell = 0; cell < state.cells(); ++cell) {
        const std::size_t line = cell / state.columns;
        state.conc[0][cell] = start(static_cast<double>(cell % state.columns), static_cast<double>(line % state.rows),
                                    static_cast<double>(line / state.rows));
    }
    state.diff[0].assign(state.cells(), rate);
    return state;
}

// The stencil's symbol at wave numbers p, q, r.
double symbol(Stencil stencil, double p, double q, double r) {
    const double x = 2 * std::cos(p), y = 2 * std::cos(q), z = 2 * std::cos(r);
    if (stencil == Stencil::seven_point) return x + y + z - 6;
    return (14 * (x + y + z) + 3 * (x * y + y * z + z * x) + x * y * z - 128) / 30;
}

// The largest error of a wave's Laplacian on so many cells a side, in units of the wave's own Laplacian.
double error_of_laplacian(Stencil stencil, std::size_t side) {
    Experiment experiment = test::volume(side, side, side, Boundary::wrap, stencil);
    const double k = 2 * std::numbers::pi / static_cast<double>(side);
    const auto wave = [&](double x, double y, double z) {
        return std::sin(k * x) * std::cos(k * y) + std::sin(2 * k * z + k * x);
    };
    const auto laplacian = [&](double x, double y, double z) {
        return -2 * std::sin(k * x) * std::cos(k * y) - 5 * std::sin(2 * k * z + k * x);
    };
    const Snapshot before = started(experiment, 1.0, wave);
    const Snapshot exact = started(experiment, 1.0, laplacian);
    const Snapshot after = test::after(1, experiment, before);
    double worst = 0.0;
    for (std::size_t cell = 0; cell < before.cells(); ++cell)
        worst = std::max(worst, std::abs((after.conc[0][cell] - before.conc[0][cell]) / (k * k) - exact.conc[0][cell]));
    return worst;
}

}  // namespace

TEST_CASE("volume: seven points from the middle, worked by hand, whatever the boundary") {
    for (const Boundary boundary : volume_boundaries) {
        const std::vector<double> found = spread_from(13, boundary, Stencil::seven_point);
        std::vector<double> worked(27, 0.0);
        for (const std::size_t face : {4, 10, 12, 14, 16, 22}) worked[face] = 1.0;
        worked[13] = 1.0 - 6.0;
        CHECK(found == worked);
    }
}

TEST_CASE("volume: seven points from a corner, worked by hand for every boundary") {
    std::vector<double> worked(27, 0.0);
    for (const std::size_t face : {1, 3, 9}) worked[face] = 1.0;
    worked[0] = 1.0 - 6.0;
    CHECK(spread_from(0, Boundary::absorbing, Stencil::seven_point) == worked);
    worked[0] = 1.0 - 3.0;  // it sees itself beyond three faces
    CHECK(spread_from(0, Boundary::no_flux, Stencil::seven_point) == worked);
    worked[0] = 1.0 - 6.0;
    for (const std::size_t face : {2, 6, 18}) worked[face] = 1.0;
    CHECK(spread_from(0, Boundary::wrap, Stencil::seven_point) == worked);
}

TEST_CASE("volume: twenty-seven points from the middle and from a corner, worked by hand") {
    const auto thirtieths = [](std::size_t from, Boundary boundary) {
        std::vector<long> numbers;
        for (const double value : spread_from(from, boundary, Stencil::twenty_seven_point))
            numbers.push_back(std::lround(30 * value));
        return numbers;
    };
    const std::vector<long> middle{1, 3,  1, 3,  14,  3,  1, 3,  1,  //
                                   3, 14, 3, 14, -98, 14, 3, 14, 3,  //
                                   1, 3,  1, 3,  14,  3,  1, 3,  1};
    for (const Boundary boundary : volume_boundaries) CHECK(thirtieths(13, boundary) == middle);
    const std::vector<long> absorbing{-98, 14, 0, 14, 3, 0, 0, 0, 0, 14, 3, 0, 3, 1,
                                      0,   0,  0, 0,  0, 0, 0, 0, 0, 0,  0, 0, 0};
    CHECK(thirtieths(0, Boundary::absorbing) == absorbing);
    // Beyond faces, edges and the corner it sees itself: 3 * 14 + 3 * 3 + 1 = 52; its neighbour at a face sees it
    // beyond two faces and an edge: 14 + 2 * 3 + 1 = 21; at an edge: 3 + 1 = 4.
    const std::vector<long> no_flux{-46, 21, 0, 21, 4, 0, 0, 0, 0, 21, 4, 0, 4, 1,
                                    0,   0,  0, 0,  0, 0, 0, 0, 0, 0,  0, 0, 0};
    CHECK(thirtieths(0, Boundary::no_flux) == no_flux);
    const std::vector<long> torus{-98, 14, 14, 14, 3,  3, 14, 3, 3, 14, 3, 3, 3, 1,
                                  1,   3,  1,  1,  14, 3, 3,  3, 1, 1,  3, 1, 1};
    CHECK(thirtieths(0, Boundary::wrap) == torus);
}

TEST_CASE("volume: mass is kept unless a face absorbs it, whether rates are alike or not") {
    for (const Stencil stencil : volume_stencils) {
        for (const Boundary boundary : volume_boundaries) {
            for (const bool own : {false, true}) {
                const Experiment experiment = test::volume(7, 5, 4, boundary, stencil);
                Snapshot state = test::blank(experiment);
                state.conc[0] = test::scatter(140, 0.0, 1.0, 3);
                state.diff[0] = own ? test::scatter(140, 0.0, 0.1, 4) : std::vector<double>(140, 0.1);
                const double before = test::sum(state.conc[0]);
                const double after = test::sum(test::after(50, experiment, state).conc[0]);
                if (boundary == Boundary::absorbing)
                    CHECK(after < 0.9 * before);
                else
                    CHECK(after == Approx(before).epsilon(1e-13));
            }
        }
    }
}

TEST_CASE("volume: waves decay as the stencil's symbol says") {
    constexpr double turn = 2 * std::numbers::pi;
    for (const Stencil stencil : volume_stencils) {
        const Experiment experiment = test::volume(8, 6, 10, Boundary::wrap, stencil);
        const double p = turn / 8, q = 2 * turn / 6, r = 3 * turn / 10;
        const auto wave = [&](double x, double y, double z) { return std::cos(p * x + q * y + r * z); };
        const Snapshot before = started(experiment, 0.05, wave);
        const Snapshot after = test::after(20, experiment, before);
        const double factor = std::pow(1 + 0.05 * symbol(stencil, p, q, r), 20);
        for (std::size_t cell = 0; cell < before.cells(); ++cell)
            REQUIRE(after.conc[0][cell] == Approx(factor * before.conc[0][cell]).margin(1e-13));
    }
}

// Turing's reaction rests at u = v = 4 where alpha is 16 and beta 12. A small wave around that grows as linear theory
// says, step by step: (a, b) becomes (1 + dt (J + S D)) (a, b), J the reaction's slopes there, S the stencil's symbol.
TEST_CASE("volume: small waves of Turing's reaction grow and decay as linear theory says") {
    constexpr double turn = 2 * std::numbers::pi, dt = 0.02, rate_u = 5, rate_v = 1;
    constexpr int steps = 60;
    bool grew = false, decayed = false;
    for (const Stencil stencil : volume_stencils) {
        Experiment experiment = test::volume(8, 6, 10, Boundary::wrap, stencil, {"U", "V"});
        experiment.phases[0].time_step = dt;
        experiment.rules = {
            test::rule(React{model_named("turing"), {0, 1}, test::number(1), {test::number(16), test::number(12)}})};
        for (const auto& [i, j, k] :
             {std::array{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}, {3, 2, 4}}) {
            const double p = turn * i / 8, q = turn * j / 6, r = turn * k / 10;
            const auto wave = [&](double x, double y, double z) { return std::cos(p * x + q * y + r * z); };
            const std::vector<double> shape = started(experiment, rate_u, wave).conc[0];
            double a = 1e-7, b = 5e-8;
            Snapshot state = started(experiment, rate_u, [](double, double, double) { return 4.0; });
            state.conc[1] = state.conc[0];
            state.diff[1].assign(state.cells(), rate_v);
            for (std::size_t cell = 0; cell < state.cells(); ++cell) {
                state.conc[0][cell] += a * shape[cell];
                state.conc[1][cell] += b * shape[cell];
            }
            state = test::after(steps, experiment, state);
            const double s = symbol(stencil, p, q, r), before = std::hypot(a, b);
            for (int step = 0; step < steps; ++step) {
                const double flow_u = -4 * a - 4 * b + s * rate_u * a, flow_v = 4 * a + 3 * b + s * rate_v * b;
                a += dt * flow_u;
                b += dt * flow_v;
            }
            INFO("symbol " << s << ", from " << before << " to " << std::hypot(a, b));
            grew = grew || (i + j + k > 0 && std::hypot(a, b) > 1.1 * before);
            decayed = decayed || std::hypot(a, b) < 0.5 * before;
            for (std::size_t cell = 0; cell < state.cells(); ++cell) {
                REQUIRE(state.conc[0][cell] - 4 == Approx(a * shape[cell]).margin(1e-12));
                REQUIRE(state.conc[1][cell] - 4 == Approx(b * shape[cell]).margin(1e-12));
            }
        }
    }
    CHECK(grew);
    CHECK(decayed);
}

TEST_CASE("volume: the Laplacian is of second order in space") {
    for (const Stencil stencil : volume_stencils) {
        const double coarse = error_of_laplacian(stencil, 12);
        const double fine = error_of_laplacian(stencil, 24);
        CHECK(std::log2(coarse / fine) == Approx(2.0).margin(0.1));
    }
}

TEST_CASE("volume: the error of twenty-seven points is the same in every direction up to the fourth order") {
    const auto apart = [](Stencil stencil, double k) {
        const double axis = symbol(stencil, k, 0, 0);
        const double across =
            symbol(stencil, k / std::numbers::sqrt3, k / std::numbers::sqrt3, k / std::numbers::sqrt3);
        return std::abs(axis - across);
    };
    CHECK(std::log2(apart(Stencil::twenty_seven_point, 0.4) / apart(Stencil::twenty_seven_point, 0.2)) > 5.8);
    CHECK(std::log2(apart(Stencil::seven_point, 0.4) / apart(Stencil::seven_point, 0.2)) < 4.2);
}

TEST_CASE("volume: the largest time step is where the stiffest wave grows") {
    for (const Stencil stencil : volume_stencils) {
        const double pi = std::numbers::pi;
        double stiffest = 0.0;
        for (int i = 0; i < 8; ++i)
            stiffest = std::max(stiffest, -symbol(stencil, i & 1 ? pi : 0, i & 2 ? pi : 0, i & 4 ? pi : 0));
        CHECK(stiffness(stencil) == Approx(stiffest));
    }
}

TEST_CASE("volume: what is the same in all layers does as on the plane") {
    for (const Boundary boundary : {Boundary::no_flux, Boundary::wrap}) {
        for (const bool own : {false, true}) {
            const Experiment flat = test::matrix(9, 6, boundary, Stencil::five_point);
            Snapshot plane = test::blank(flat);
            plane.conc[0] = test::scatter(54, 0.0, 1.0, 5);
            plane.diff[0] = own ? test::scatter(54, 0.0, 0.2, 6) : std::vector<double>(54, 0.2);
            const std::vector<double> expected = test::after(30, flat, plane, Precision::single_).conc[0];
            for (const std::size_t layers : {1u, 3u}) {  // a single one is its own neighbour before and behind
                const Experiment deep = test::volume(9, 6, layers, boundary);
                Snapshot state = test::blank(deep);
                for (std::size_t cell = 0; cell < state.cells(); ++cell) {
                    state.conc[0][cell] = plane.conc[0][cell % 54];
                    state.diff[0][cell] = plane.diff[0][cell % 54];
                }
                const std::vector<double> found = test::after(30, deep, state, Precision::single_).conc[0];
                for (std::size_t cell = 0; cell < found.size(); ++cell) REQUIRE(found[cell] == expected[cell % 54]);
            }
        }
    }
}

TEST_CASE("volume: twenty-seven points of equal layers are nine points, to rounding") {
    const Experiment flat = test::matrix(9, 6, Boundary::wrap, Stencil::nine_point);
    const Experiment deep = test::volume(9, 6, 2, Boundary::wrap, Stencil::twenty_seven_point);
    Snapshot plane = test::blank(flat), state = test::blank(deep);
    plane.conc[0] = test::scatter(54, 0.0, 1.0, 7);
    plane.diff[0].assign(54, 0.1);
    state.diff[0].assign(108, 0.1);
    for (std::size_t cell = 0; cell < 108; ++cell) state.conc[0][cell] = plane.conc[0][cell % 54];
    const auto expected = test::after(20, flat, plane).conc[0];
    const auto found = test::after(20, deep, state).conc[0];
    for (std::size_t cell = 0; cell < 108; ++cell) REQUIRE(found[cell] == Approx(expected[cell % 54]).epsilon(1e-12));
}

TEST_CASE("volume: equal rates that count as each cell's own give the same but for rounding") {
    for (const Stencil stencil : volume_stencils) {
        for (const Boundary boundary : volume_boundaries) {
            // Beyond such an edge a diagonal neighbour is the one beside, or none: as on lattices.
            if (boundary == Boundary::no_flux && stencil == Stencil::twenty_seven_point) continue;
            const Experiment alike = test::volume(6, 5, 4, boundary, stencil);
            Experiment own = alike;
            own.rules.push_back(test::rule(Change{Target::rate, 0, test::number(0.0), 0.0}));
            Snapshot state = test::blank(alike);
            state.conc[0] = test::scatter(120, 0.0, 1.0, 8);
            state.diff[0].assign(120, 0.1);
            const auto expected = test::after(20, alike, state).conc[0];
            const auto found = test::after(20, own, state).conc[0];
            for (std::size_t cell = 0; cell < 120; ++cell)
                REQUIRE(found[cell] == Approx(expected[cell]).epsilon(1e-12));
        }
    }
}

TEST_CASE("volume: float stays near double, and cells have the neighbours that they count") {
    const Experiment experiment = test::volume(5, 4, 3);
    Snapshot state = test::blank(experiment);
    state.conc[0] = test::scatter(60, 0.0, 1.0, 9);
    state.diff[0].assign(60, 0.15);
    const Snapshot exact = test::after(40, experiment, state);
    const Snapshot single = test::after(40, experiment, state, Precision::single_);
    for (std::size_t cell = 0; cell < 60; ++cell)
        REQUIRE(single.conc[0][cell] == Approx(exact.conc[0][cell]).epsilon(1e-5));
    CHECK(exact.layers == 3);
    CHECK(exact.neighbours[0] == 3);
    CHECK(exact.neighbours[26] == 6);
    CHECK(test::same(single, test::after(25, experiment, test::after(15, experiment, state, Precision::single_),
                                         Precision::single_)));
}
