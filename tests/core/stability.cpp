// The explicit limit of diffusion: its eigenvalues by brute force, and the check that uses them.
#include "core/stability.hpp"

#include "core/prepattern.hpp"
#include "core/support_experiments.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace pelage;

namespace {

double eigenvalue(Stencil stencil, double p, double q) {
    const double edges = 2 * std::cos(p) + 2 * std::cos(q);
    const double corners = 4 * std::cos(p) * std::cos(q);
    switch (stencil) {
        case Stencil::moore:
            return 8 - edges - corners;
        case Stencil::nine_point:
            return (20 - 4 * edges - corners) / 6;
        case Stencil::five_point:
            return 4 - edges;
        case Stencil::sims:
            return 1 - 0.2 * edges - 0.05 * corners;
        default:
            break;  // of one's own, and of volumes: reference/volume.cpp
    }
    return 0;
}

}  // namespace

TEST_CASE("stiffness is the stencil's largest eigenvalue") {
    for (const Stencil stencil : {Stencil::moore, Stencil::nine_point, Stencil::five_point, Stencil::sims}) {
        double largest = 0.0;
        for (int i = 0; i <= 64; ++i) {
            for (int j = 0; j <= 64; ++j) {
                largest = std::max(largest, eigenvalue(stencil, std::numbers::pi * i / 64, std::numbers::pi * j / 64));
            }
        }
        CHECK(stiffness(stencil) == Approx(largest));
    }
}

TEST_CASE("stiffness of one's own weights: of waves that turn as well as shrink") {
    const auto of = [](const StencilWeights& weights) {
        Lattice lattice;
        lattice.stencil = Stencil::own;
        lattice.weights = weights;
        return stiffness(lattice);
    };
    CHECK(of({0, 1, 0, 1, -4, 1, 0, 1, 0}) == Approx(stiffness(Stencil::five_point)));
    std::vector<double> wide(25, 0.0);  // five-point of every second cell
    wide[2] = wide[10] = wide[14] = wide[22] = 1.0;
    wide[12] = -4.0;
    CHECK(of(wide) == Approx(stiffness(Stencil::five_point)));
    CHECK(of({0.05, 0.2, 0.05, 0.2, -1, 0.2, 0.05, 0.2, 0.05}) == Approx(stiffness(Stencil::sims)));
    // Upwind advection: l = exp(-i k) - 1, whose |l|^2 / -Re l is 2 for every k; the Courant number may be 1.
    CHECK(of({0, 0, 0, 1, -1, 0, 0, 0, 0}) == Approx(2.0));
    // Central advection has no stable step, nor has what sharpens.
    CHECK(std::isinf(of({0, 0, 0, 0.5, 0, -0.5, 0, 0, 0})));
    CHECK(std::isinf(of({0, -1, 0, -1, 4, -1, 0, -1, 0})));
}

TEST_CASE("an unstable step is found, with the largest that holds") {
    Experiment experiment = test::turing_matrix(8, 8);
    CHECK_FALSE(find_instability(experiment, initial_state(experiment)));

    experiment.phases.front().time_step = 0.1;
    const auto found = find_instability(experiment, initial_state(experiment));

    REQUIRE(found);
    CHECK(found->chemical == "U");
    CHECK(found->rate == 5.0);
    CHECK(found->largest_time_step == Approx(2 / (5 * 16.0 / 3)));
    experiment.phases.front().time_step = found->largest_time_step;
    CHECK_FALSE(find_instability(experiment, initial_state(experiment)));
}

TEST_CASE("a later phase's rates are judged too") {
    Experiment experiment = test::turing_matrix(8, 8);
    experiment.phases.push_back(experiment.phases.front());
    experiment.phases.back().name = "late";
    experiment.phases.back().begin = 100;
    experiment.phases.back().rates[1] = 100.0;

    const auto found = find_instability(experiment, initial_state(experiment));

    REQUIRE(found);
    CHECK(found->phase == "late");
    CHECK(found->chemical == "V");
}
