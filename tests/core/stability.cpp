// The explicit limit of diffusion: its eigenvalues by brute force, and the check that uses them.
#include "core/stability.hpp"

#include "core/digits.hpp"
#include "core/prepattern.hpp"
#include "core/support_experiments.hpp"
#include "language/parse.hpp"

#include <fmt/format.h>
#include <catch2/catch.hpp>

#include <cmath>
#include <memory>
#include <numbers>
#include <string>

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

TEST_CASE("messages have the shortest digits of a number, of one that is a float those of a float") {
    CHECK(digits(double{0.3f}) == "0.3");
    CHECK(digits(0.3) == "0.3");
    CHECK(digits(0.1 + 0.2) == "0.30000000000000004");
    CHECK(digits(-0.125) == "-0.125");
    CHECK(digits(123456789.0) == "123456789");
    CHECK(digits(1e300) == "1e+300");
    CHECK(std::stof(digits(double{0.1f + 0.2f})) == 0.1f + 0.2f);

    Experiment drawn =
        parse_experiment("define chemical U\nuse chemical U diff 0.3\ncreate matrix 4 4\n", "t.pex", ".");
    drawn.phases[0].time_step = 2.0;
    CHECK(find_instability(drawn, initial_state(drawn))->rates() == "a rate of 0.3");
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

TEST_CASE("the diffusion of networks is judged: by groups, beside the chemicals' own rates, on every kind of space") {
    Experiment experiment = parse_experiment("define chemicals x 4\ncreate matrix 8 8\n", "t.pex", ".");
    Neural neural;
    neural.species = {0, 1, 2, 3};
    neural.network = std::make_shared<const Network>(make_network(4, 1, {0, 0, 0, 0}, {0}, {0, 0, 0, 0}, "still"));
    neural.diffusion = Operand::number(0.37);  // the limit of the fastest group is 2 / (16 / 3) = 0.375
    experiment.rules.push_back({});
    experiment.rules[0].line = 7;
    experiment.rules[0].action = neural;
    const auto found = [&] { return find_instability(experiment, initial_state(experiment)); };
    const auto diffusion = [&](std::size_t rule, double value) {
        std::get<Neural>(experiment.rules[rule].action).diffusion = Operand::number(value);
    };
    CHECK_FALSE(found());
    diffusion(0, 0.38);
    REQUIRE(found());
    CHECK(found()->chemical == "x3");
    CHECK(found()->network == 0.38);
    CHECK(found()->line == 7);
    CHECK(found()->largest_time_step == Approx(0.375 / 0.38));
    CHECK(found()->rates() == "a network's rate of 0.38");
    experiment.rules[0].until = 10;
    CHECK(found());
    experiment.rules[0].condition = Probability{Operand::number(0.5)};
    CHECK_FALSE(found());

    experiment.rules[0].condition = Always{};
    diffusion(0, 0.2);
    experiment.rules.push_back(experiment.rules[0]);
    CHECK(found());  // the two at once
    for (Rule& rule : experiment.rules) rule.every = 2;
    experiment.rules[1].offset = 1;
    CHECK_FALSE(found());  // in turns
    experiment.phases[0].rates[3] = 0.2;
    REQUIRE(found());
    CHECK(found()->rates() == "a rate of 0.2 and 0.2 by a network");
}

TEST_CASE("a network's diffusion has the limit of the space's stencil") {
    const auto stable = [](const std::string& space, double diffusion) {
        const std::string folder = PELAGE_SOURCE "/tests/io/networks";
        const Experiment experiment = parse_experiment(
            fmt::format("define chemicals x 4\n{}\nrule always react all neural \"stored.npz\" diffusion {}\n", space,
                        diffusion),
            "t.pex", folder);
        return !find_instability(experiment, initial_state(experiment)).has_value();
    };
    CHECK(stable("create volume 4 4 4", 1 / 6.1));
    CHECK_FALSE(stable("create volume 4 4 4", 1 / 5.9));
    CHECK(stable("define stencil twenty-seven-point\ncreate volume 4 4 4", 15 / 46.1));
    CHECK_FALSE(stable("define stencil twenty-seven-point\ncreate volume 4 4 4", 15 / 45.9));
    CHECK(stable("create icosphere 2", 0.15));
    CHECK_FALSE(stable("create icosphere 2", 0.5));
}
