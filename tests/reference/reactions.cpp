// The reaction models: fixed points, and values worked by hand.
#include "core/error.hpp"
#include "lab.hpp"
#include "reference/rules/flow.hpp"
#include "reference/rules/reaction.hpp"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>

namespace {

using namespace pelage;

React react(Model model, const std::vector<double>& parameters, double scale = 1.0) {
    React result{model, {0, 1}, test::number(scale), {}};
    result.species.resize(model.facts().species.size());
    for (const double p : parameters) result.parameters.push_back(test::number(p));
    return result;
}

struct Pair {
    double u;
    double v;
};

// One iteration of a matrix (fused) or a square grid (published), without diffusion, of cells that start alike.
Pair once(const React& reaction, Pair start, bool published, Precision precision, double time_step = 1.0) {
    const std::vector<std::string> names{"U", "V"};
    Experiment experiment =
        published ? test::grid(3, 2, false, names) : test::matrix(3, 2, Boundary::wrap, Stencil::nine_point, names);
    experiment.phases[0].time_step = time_step;
    experiment.rules = {test::rule(reaction)};
    Snapshot state = test::blank(experiment);
    state.conc = {std::vector<double>(6, start.u), std::vector<double>(6, start.v)};
    const Snapshot end = test::after(1, experiment, state, precision);
    CHECK(test::spread(end.conc[0]) == 0.0);
    CHECK(test::spread(end.conc[1]) == 0.0);
    return {end.conc[0][0], end.conc[1][0]};
}

// All numbers are exact in binary, so both arithmetics and precisions give them exactly.
void check_exact(const React& reaction, Pair start, Pair wanted) {
    for (const Precision precision : {Precision::single_, Precision::double_}) {
        for (const bool published : {false, true}) {
            const Pair end = once(reaction, start, published, precision, 0.25);
            CHECK(end.u == wanted.u);
            CHECK(end.v == wanted.v);
        }
    }
}

}  // namespace

TEST_CASE("turing: alpha - u v and u v - v - beta") {
    check_exact(react(model_named("turing"), {16, 12}, 0.5), {2, 3}, {2 + 0.125 * 10, 3 + 0.125 * -9});
}

TEST_CASE("gray-scott: -u v v + f (1 - u) and u v v - (f + k) v") {
    check_exact(react(model_named("gray-scott"), {0.125, 0.0625}), {0.5, 0.25},
                {0.5 + 0.25 * (-0.03125 + 0.0625), 0.25 + 0.25 * (0.03125 - 0.046875)});
}

TEST_CASE("linear: production within its bounds, less decay") {
    const std::vector<double> inside{0.5, -0.25, 1, 0.125, 8, 0.25, 0.5, -1, 0.5, 8};
    check_exact(react(model_named("linear"), inside), {4, 2}, {4 + 0.25 * (2.5 - 0.5), 2 + 0.25 * (1 - 1)});

    const std::vector<double> bounded{0.5, -0.25, 1, 0.125, 2, 0.25, 0.5, -4, 0.5, 8};
    check_exact(react(model_named("linear"), bounded), {4, 2}, {4 + 0.25 * (2 - 0.5), 2 + 0.25 * (0 - 1)});
}

TEST_CASE("gm1: a - b u + u u / (v (1 + c u u)) and u u - v") {
    check_exact(react(model_named("gm1"), {1, 0.25, 0.25}), {2, 0.5}, {2 + 0.25 * (0.5 + 4), 0.5 + 0.25 * 3.5});
}

TEST_CASE("cubic: (u - a)(u - b)(u - c), on u alone") {
    check_exact(react(model_named("cubic"), {1, 0, 4}, 2), {2, 7}, {2 + 0.25 * 2 * -4, 7});
}

TEST_CASE("turing: nothing happens at u = v = 4 with alpha 16 and beta 12") {
    check_exact(react(model_named("turing"), {16, 12}, 0.3), {4, 4}, {4, 4});
    const Pair off = once(react(model_named("turing"), {16, 12}), {4, 4.5}, false, Precision::double_);
    CHECK(off.u < 4);
}

TEST_CASE("gray-scott: nothing happens at u = 1, v = 0") {
    check_exact(react(model_named("gray-scott"), {0.0367, 0.0620}), {1, 0}, {1, 0});
    const Pair off = once(react(model_named("gray-scott"), {0.0367, 0.0620}), {0.9, 0}, false, Precision::double_);
    CHECK(off.u == Approx(0.9 + 0.00367));
}

TEST_CASE("cubic: nothing happens at its roots") {
    for (const double root : {0.25, 1.0, -3.0})
        check_exact(react(model_named("cubic"), {0.25, 1, -3}), {root, 5}, {root, 5});
}

TEST_CASE("reinforcement: roots at t - w, t and t + w, t being unstable, fastest change w") {
    const React reaction = react(model_named("reinforcement"), {2.5, 0.5});
    for (const double root : {2.0, 2.5, 3.0}) check_exact(reaction, {root, 1}, {root, 1});

    const auto change = [&](double c) { return once(reaction, {c, 1}, false, Precision::double_).u - c; };
    CHECK(change(2.4) < 0.0);
    CHECK(change(2.6) > 0.0);
    CHECK(change(3.1) < 0.0);
    CHECK(change(1.9) > 0.0);
    CHECK(change(2.5 + 0.5 / std::sqrt(3.0)) == Approx(0.5));
    CHECK(change(2.5 - 0.5 / std::sqrt(3.0)) == Approx(-0.5));
}

TEST_CASE("scale and parameters may differ from cell to cell") {
    Experiment experiment = test::matrix(3, 1, Boundary::no_flux, Stencil::nine_point, {"U", "V", "S", "B"});
    React reaction = react(model_named("turing"), {16, 0});
    reaction.scale = Operand::concentration(2);
    reaction.parameters[1] = Operand::concentration(3);
    experiment.rules = {test::rule(reaction)};
    Snapshot state = test::blank(experiment);
    state.conc = {{2, 2, 2}, {3, 3, 3}, {0, 0.5, 1}, {12, 11, 10}};

    const Snapshot end = test::after(1, experiment, state);

    CHECK(end.conc[0] == std::vector<double>{2, 7, 12});
    CHECK(end.conc[1] == std::vector<double>{3, 3 + 0.5 * -8, 3 - 7});
}

TEST_CASE("a reaction acts only where its condition holds") {
    Experiment experiment = test::matrix(3, 1, Boundary::no_flux, Stencil::nine_point, {"U", "V"});
    experiment.rules = {test::rule(react(model_named("turing"), {16, 12}),
                                   test::compare(Operand::concentration(0), Comparison::greater, test::number(2)))};
    Snapshot state = test::blank(experiment);
    state.conc = {{2, 3, 1}, {3, 3, 3}};

    const Snapshot end = test::after(1, experiment, state);

    CHECK(end.conc[0] == std::vector<double>{2, 3 + 7, 1});
    CHECK(end.conc[1] == std::vector<double>{3, 3 - 6, 3});
}

namespace {

// As a newcomer may write it: one chemical, one parameter more than any model had.
struct Eleven {
    static constexpr std::string_view word = "eleven";
    static constexpr std::size_t species = 1;
    static constexpr std::size_t parameters = 11;

    template <class T, class P>
    static reference::Flow<T, 1> flow(T u, const P& p) {
        T sum = u;
        for (std::size_t i = 0; i < 11; ++i) sum = sum + p[i];
        return {sum};
    }
};

// Where one cell, 1, comes to in a time step of 1.
float eleven(const React& react) {
    reference::State<float> old;
    old.conc = {{1.0f}};
    reference::State<float> next = old;
    const Experiment experiment;
    const reference::Ground<float> ground;
    reference::Sight<float> sight{experiment, old, old.mappings, ground, 0, 1, 0};
    const std::vector<std::uint8_t> truth{1};
    reference::Reaction<float>(react, sight, next, truth).run<Eleven>(reference::Fused<float>{1.0f});
    return next.conc[0][0];
}

}  // namespace

TEST_CASE("a model has as many parameters as it says, more than ten too") {
    React react{Model{}, {0}, test::number(1), std::vector<Operand>(11, test::number(0))};
    for (std::size_t i = 0; i < 11; ++i) react.parameters[i] = test::number(std::ldexp(1.0, static_cast<int>(i)));
    CHECK(eleven(react) == 1 + 1 + 2047);

    for (const std::size_t count : {0u, 10u, 12u}) {
        react.parameters.resize(count, test::number(0));
        CHECK_THROWS_AS(eleven(react), Error);
    }
    react.parameters.resize(11, test::number(0));
    react.species = {0, 0};
    CHECK_THROWS_AS(eleven(react), Error);
}
