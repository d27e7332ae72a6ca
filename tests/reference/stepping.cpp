// Whole runs: splitting, resuming, phases, bounds, numbers that are none.
#include "core/error.hpp"
#include "lab.hpp"
#include "reference/backend.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

namespace {

using namespace pelage;

const double infinity = std::numeric_limits<double>::infinity();

// Something of everything: reaction, chance, deviation, mappings, set, periodic rules, polarity, expansion, phases.
Experiment busy(bool grid) {
    const std::vector<std::string> names{"U", "V", "M"};
    Experiment experiment =
        grid ? test::grid(9, 7, true, names) : test::matrix(9, 7, Boundary::no_flux, Stencil::nine_point, names);
    experiment.mappings = {"scale"};
    experiment.chemicals[1].anisotropic = true;
    experiment.phases[0].time_step = 0.05;
    experiment.phases.push_back(experiment.phases[0]);
    experiment.phases[1].begin = 13;
    experiment.phases[1].time_step = 0.04;
    experiment.phases[1].bounds[0] = {0.0, 4.5};
    experiment.phases[1].rates[0] = 0.9;
    const Operand mapping{Quantity::mapping, 0.0, 0};
    experiment.rules = {
        test::rule(Map{Operand::concentration(2), 0.0, 1.0, 0, 0.5, 1.5}),
        test::rule(React{model_named("turing"), {0, 1}, mapping, {test::number(16), test::number(12)}}),
        test::rule(Polarize{0}),
        test::rule(Change{Target::concentration, 2, test::number(0.01), 0.02}, Probability{test::number(0.3)}),
        test::rule(And{}, test::compare({Quantity::random}, Comparison::less, test::number(0.5))),
        test::rule(Set{Target::concentration, 2, Operand::concentration(0)},
                   test::compare({Quantity::neighbours}, Comparison::greater, test::number(3))),
        test::rule(Change{Target::rate, 1, test::number(-0.001), 0.002}),
    };
    experiment.rules[5].every = 4;
    if (grid) return experiment;  // only a matrix grows
    Rule growth = test::rule(Expand{1, 1, true, Distribution::uniform, 1.0, 0.0, 0.0, true});
    growth.every = 10;
    growth.offset = 6;
    experiment.rules.push_back(growth);
    return experiment;
}

Snapshot busy_state(const Experiment& experiment) {
    Snapshot state = test::blank(experiment);
    const std::size_t cells = state.cells();
    state.conc = {test::scatter(cells, 3, 5, 1), test::scatter(cells, 3, 5, 2), test::scatter(cells, 0, 1, 3)};
    state.diff = {std::vector<double>(cells, 0.8), test::scatter(cells, 0.1, 0.3, 4), std::vector<double>(cells, 0.01)};
    return state;
}

}  // namespace

TEST_CASE("advance splits anywhere without changing a bit") {
    for (const bool grid : {false, true}) {
        for (const Precision precision : {Precision::single_, Precision::double_}) {
            const Experiment experiment = busy(grid);
            const Snapshot initial = busy_state(experiment);
            const Snapshot whole = test::after(40, experiment, initial, precision);
            REQUIRE(whole.columns == (grid ? 9 : 13));
            REQUIRE(test::spread(whole.conc[0]) > 0.1);

            for (const std::uint64_t first : {1u, 5u, 6u, 7u, 13u, 14u, 39u}) {
                const auto tissue = test::start(experiment, initial, precision);
                tissue->advance(first);
                tissue->advance(40 - first);
                CHECK(test::same(tissue->read(), whole));
            }
        }
    }
}

TEST_CASE("a state read and written elsewhere goes on with the same bits") {
    for (const Precision precision : {Precision::single_, Precision::double_}) {
        const Experiment experiment = busy(false);
        const Snapshot initial = busy_state(experiment);
        const Snapshot whole = test::after(40, experiment, initial, precision);
        const Snapshot middle = test::after(22, experiment, initial, precision);

        const Snapshot made = test::after(18, experiment, middle, precision);
        const auto written = test::start(experiment, initial, precision);
        written->write(middle);
        written->advance(18);

        CHECK(test::same(made, whole));
        CHECK(test::same(written->read(), whole));
    }
}

TEST_CASE("the run's seed moves its draws") {
    Experiment experiment = busy(false);
    const Snapshot initial = busy_state(experiment);
    const Snapshot first = test::after(5, experiment, initial);
    experiment.seed = 2;
    const Snapshot second = test::after(5, experiment, initial);

    CHECK(first.conc[2] != second.conc[2]);
}

TEST_CASE("a phase sets rates, time step and bounds from its first iteration on") {
    Experiment experiment = test::matrix(2, 1, Boundary::no_flux, Stencil::five_point);
    experiment.phases.push_back(experiment.phases[0]);
    experiment.phases[1].begin = 2;
    experiment.phases[1].time_step = 0.5;
    experiment.phases[1].rates[0] = 0.25;
    experiment.phases[1].bounds[0] = {-infinity, 6.5};
    Snapshot state = test::blank(experiment);
    state.conc[0] = {0, 8};

    CHECK(test::after(2, experiment, state).conc[0] == std::vector<double>{0, 8});
    CHECK(test::after(3, experiment, state).conc[0] == std::vector<double>{1, 6.5});
    CHECK(test::after(3, experiment, state).diff[0] == std::vector<double>{0.25, 0.25});
}

TEST_CASE("concentrations stay between floor and limit") {
    Experiment experiment = test::matrix(4, 1, Boundary::no_flux, Stencil::nine_point, {"A", "B"});
    experiment.phases[0].bounds = {{-1.0, 2.0}, {-infinity, infinity}};
    const Change up{Target::concentration, 0, Operand::concentration(1), 0.0};
    experiment.rules = {test::rule(up)};
    Snapshot state = test::blank(experiment);
    state.conc = {{0, 0, 0, 0}, {-5, -0.5, 1.5, 1e30}};

    const Snapshot end = test::after(1, experiment, state);

    CHECK(end.conc[0] == std::vector<double>{-1, -0.5, 1.5, 2});
    CHECK(end.conc[1] == state.conc[1]);
}

TEST_CASE("a NaN stays one, spreads, and is found") {
    for (Experiment experiment : {test::grid(5, 3, false, {"A", "B"}),
                                  test::matrix(5, 3, Boundary::no_flux, Stencil::nine_point, {"A", "B"})}) {
        experiment.phases[0].bounds = {{0.0, 1.0}, {0.0, 1.0}};
        Snapshot state = test::blank(experiment);
        state.conc[1].assign(15, 0.5);
        state.diff[1].assign(15, 0.05);
        const auto tissue = test::start(experiment, state, Precision::single_);
        CHECK_FALSE(tissue->non_finite().has_value());

        state.conc[1][8] = std::nan("");
        tissue->write(state);
        tissue->advance(1);

        const auto found = tissue->non_finite();
        REQUIRE(found.has_value());
        CHECK(found->chemical == 1);
        CHECK(found->cell == 2);
        const Snapshot end = tissue->read();
        CHECK(std::isnan(end.conc[1][8]));
        CHECK(std::isnan(end.conc[1][12]));
        CHECK(end.conc[1][0] == Approx(0.5));
        CHECK(end.conc[0][8] == 0.0);
    }
}

TEST_CASE("an infinity is found, in order of chemical and cell") {
    const Experiment experiment = test::matrix(3, 3, Boundary::no_flux, Stencil::nine_point, {"A", "B"});
    Snapshot state = test::blank(experiment);
    state.conc[1][2] = -infinity;
    state.conc[0][7] = infinity;

    const auto found = test::start(experiment, state)->non_finite();

    REQUIRE(found.has_value());
    CHECK(found->chemical == 0);
    CHECK(found->cell == 7);
}

TEST_CASE("lattices of one cell and of one line run") {
    for (const Boundary boundary : {Boundary::no_flux, Boundary::wrap, Boundary::absorbing}) {
        for (const auto& [columns, rows] : {std::pair<std::size_t, std::size_t>{1, 1}, {1, 6}, {6, 1}, {2, 3}}) {
            const Experiment experiment = test::matrix(columns, rows, boundary);
            Snapshot state = test::blank(experiment);
            state.conc[0] = test::scatter(state.cells(), 1, 2, 5);
            state.diff[0].assign(state.cells(), 0.1);

            const Snapshot end = test::after(20, experiment, state);

            if (boundary == Boundary::absorbing) {
                CHECK(test::sum(end.conc[0]) < 0.9 * test::sum(state.conc[0]));
            } else {
                CHECK(test::sum(end.conc[0]) == Approx(test::sum(state.conc[0])));
                CHECK(test::spread(end.conc[0]) <= 0.9 * test::spread(state.conc[0]));
            }
        }
    }
}

TEST_CASE("the reference names itself and takes every experiment") {
    const auto backend = reference_backend(Precision::single_);

    CHECK(backend->name() == "reference");
    CHECK(backend->precision() == Precision::single_);
    CHECK(reference_backend(Precision::double_)->precision() == Precision::double_);
    CHECK(backend->why_not(test::matrix(2, 2)).empty());
    CHECK_THROWS_AS(backend->make_tissue(test::matrix(2, 2), Snapshot{}), Error);
}
