// Expansion: what is duplicated, what shifts, and the way back.
#include "core/error.hpp"
#include "core/growable.hpp"
#include "lab.hpp"

#include <catch2/catch.hpp>

#include <algorithm>

namespace {

using namespace pelage;
using Values = std::vector<double>;

Experiment two_chemicals(std::size_t columns, std::size_t rows) {
    Experiment experiment = test::matrix(columns, rows, Boundary::wrap, Stencil::nine_point, {"A", "B"});
    experiment.mappings = {"m"};
    return experiment;
}

// Leaves out the element behind each pick: the way back to the original.
Values project(const Values& grown, std::size_t columns, const Insertion& insertion) {
    const std::size_t old_columns = insertion.column ? columns - 1 : columns;
    Values result(grown.size() - insertion.picks.size());
    for (std::size_t cell = 0; cell < result.size(); ++cell) {
        std::size_t column = cell % old_columns, row = cell / old_columns;
        std::size_t& place = insertion.column ? column : row;
        if (place > insertion.picks[insertion.column ? row : column]) ++place;
        result[cell] = grown[row * columns + column];
    }
    return result;
}

}  // namespace

TEST_CASE("a column is inserted by duplicating the pick of each row") {
    const Experiment experiment = test::matrix(3, 3);
    Snapshot state = test::blank(experiment);
    state.conc[0] = {1, 2, 3,  //
                     4, 5, 6,  //
                     7, 8, 9};
    const auto tissue = test::start(experiment, state);

    growable(*tissue).expand({true, {0, 1, 2}});

    const Snapshot grown = tissue->read();
    CHECK(grown.columns == 4);
    CHECK(grown.rows == 3);
    CHECK(grown.conc[0] == Values{1, 1, 2, 3,  //
                                  4, 5, 5, 6,  //
                                  7, 8, 9, 9});
    CHECK(Values(grown.x.begin(), grown.x.begin() + 4) == Values{-3, -1, 1, 3});
    CHECK(grown.y[4] == 0);
}

TEST_CASE("a row is inserted by duplicating the pick of each column") {
    const Experiment experiment = test::matrix(3, 2);
    Snapshot state = test::blank(experiment);
    state.conc[0] = {1, 2, 3,  //
                     4, 5, 6};
    const auto tissue = test::start(experiment, state);

    growable(*tissue).expand({false, {0, 1, 0}});

    const Snapshot grown = tissue->read();
    CHECK(grown.columns == 3);
    CHECK(grown.rows == 3);
    CHECK(grown.conc[0] == Values{1, 2, 3,  //
                                  1, 5, 3,  //
                                  4, 5, 6});
    CHECK(tissue->cells() == 9);
}

TEST_CASE("expansion then projection returns the original, in every field") {
    for (const bool column : {true, false}) {
        const Experiment experiment = two_chemicals(7, 5);
        Snapshot state = test::blank(experiment);
        state.iteration = 35;
        const auto field = [](std::uint32_t seed) { return test::scatter(35, -1, 1, seed); };
        state.conc = {field(1), field(2)};
        state.diff = {test::scatter(35, 0, 1, 3), test::scatter(35, 0, 1, 4)};
        state.mappings = {field(5)};
        state.polarity_x = field(6);
        state.polarity_y = field(7);
        for (std::size_t cell = 0; cell < 35; ++cell) {
            state.birth[cell] = static_cast<std::uint32_t>(cell);
            state.neighbours[cell] = static_cast<std::int32_t>(cell % 9);
            state.fixed[cell] = cell % 3 == 0;
        }
        Insertion insertion{column, {}};
        for (const double u : test::scatter(column ? 5 : 7, 0, column ? 7 : 5, 8)) {
            insertion.picks.push_back(static_cast<std::uint32_t>(u));
        }
        const auto tissue = test::start(experiment, state);

        growable(*tissue).expand(insertion);

        const Snapshot grown = tissue->read();
        const auto back = [&](const auto& values) {
            return project(Values(values.begin(), values.end()), grown.columns, insertion);
        };
        const auto doubles = [](const auto& values) { return Values(values.begin(), values.end()); };
        REQUIRE(grown.cells() == (column ? 40u : 42u));
        for (const std::size_t c : {0u, 1u}) {
            CHECK(back(grown.conc[c]) == state.conc[c]);
            CHECK(back(grown.diff[c]) == state.diff[c]);
        }
        CHECK(back(grown.mappings[0]) == state.mappings[0]);
        CHECK(back(grown.polarity_x) == state.polarity_x);
        CHECK(back(grown.polarity_y) == state.polarity_y);
        CHECK(back(grown.birth) == doubles(state.birth));
        CHECK(back(grown.neighbours) == doubles(state.neighbours));
        CHECK(back(grown.fixed) == doubles(state.fixed));
    }
}

TEST_CASE("a duplicate is born in the iteration in which it is inserted") {
    const Experiment experiment = test::matrix(3, 2);
    Snapshot state = test::blank(experiment);
    state.iteration = 7;
    state.birth = {1, 2, 3, 4, 5, 6};
    const auto tissue = test::start(experiment, state);

    growable(*tissue).expand({true, {0, 2}});
    CHECK(tissue->read().birth == std::vector<std::uint32_t>{1, 7, 2, 3, 4, 5, 6, 7});

    tissue->advance(1);
    growable(*tissue).expand({false, {1, 0, 1, 0}});
    CHECK(tissue->read().birth == std::vector<std::uint32_t>{1, 7, 2, 3, 4, 8, 6, 8, 8, 5, 8, 7});
}

TEST_CASE("a stretched matrix: concentrations are interpolated, all else is the nearest element's") {
    Experiment experiment = test::matrix(2, 1, Boundary::no_flux, Stencil::nine_point, {"A", "B"});
    experiment.phases.front().bounds[1] = {0.0, 2.0};
    experiment.mappings = {"m"};
    Expand growth;
    growth.columns = 2;
    growth.rows = 1;
    growth.interpolation = Interpolation::bilinear;
    Rule rule = test::rule(growth);
    rule.from = rule.until = 2;
    experiment.rules = {rule};
    Snapshot state = test::blank(experiment);
    state.conc = {{1, 3}, {1, 5}};
    state.diff = {{0, 0}, {0, 0}};
    state.mappings = {{10, 20}};
    state.iteration = 2;
    state.birth = {1, 2};
    state.fixed = {0, 1};

    const Snapshot grown = test::after(1, experiment, state);

    CHECK(grown.columns == 4);
    CHECK(grown.rows == 2);
    CHECK(grown.conc[0] == Values{1, 1.5, 2.5, 3, 1, 1.5, 2.5, 3});
    CHECK(grown.conc[1] == Values{1, 2, 2, 2, 1, 2, 2, 2});  // at its limit
    CHECK(grown.mappings[0] == Values{10, 10, 20, 20, 10, 10, 20, 20});
    CHECK(grown.birth == std::vector<std::uint32_t>{1, 1, 2, 2, 1, 1, 2, 2});
    CHECK(grown.fixed == std::vector<std::uint8_t>{0, 0, 1, 1, 0, 0, 1, 1});
    CHECK(Values(grown.x.begin(), grown.x.begin() + 4) == Values{-3, -1, 1, 3});
}

TEST_CASE("an even matrix stays even to the bit, however it is stretched") {
    for (const auto way : {Interpolation::nearest, Interpolation::bilinear, Interpolation::bicubic}) {
        Experiment experiment = test::matrix(7, 5, Boundary::wrap);
        Expand growth;
        growth.columns = 3;
        growth.rows = 2;
        growth.interpolation = way;
        experiment.rules = {test::rule(growth)};
        Snapshot state = test::blank(experiment);
        state.conc[0] = Values(35, double{0.1f});

        const Snapshot grown = test::after(4, experiment, state);

        CHECK(grown.conc[0] == Values(19 * 13, double{0.1f}));
    }
}

TEST_CASE("expand rules act before the iteration's other rules and see the new size") {
    Experiment experiment = two_chemicals(4, 3);
    Rule growth = test::rule(Expand{2, 1, false, Distribution::uniform, 1.0, 0.0, 0.0, true});
    growth.every = 3;
    growth.offset = 1;
    const auto store = [](std::size_t chemical, Quantity quantity) {
        return test::rule(Set{Target::concentration, chemical, {quantity}});
    };
    experiment.rules = {store(0, Quantity::columns), growth, store(1, Quantity::rows)};
    const Snapshot state = test::blank(experiment);
    const auto size = [&](std::uint64_t iterations) {
        const Snapshot end = test::after(iterations, experiment, state);
        CHECK(end.conc[0] == Values(end.cells(), static_cast<double>(end.columns)));
        CHECK(end.conc[1] == Values(end.cells(), static_cast<double>(end.rows)));
        return std::pair{end.columns, end.rows};
    };

    CHECK(size(1) == std::pair<std::size_t, std::size_t>{4, 3});
    CHECK(size(2) == std::pair<std::size_t, std::size_t>{6, 4});
    CHECK(size(4) == std::pair<std::size_t, std::size_t>{6, 4});
    CHECK(size(5) == std::pair<std::size_t, std::size_t>{8, 5});
}

TEST_CASE("a grown tissue diffuses as one that was that large from the start") {
    Experiment small = two_chemicals(6, 4);
    Snapshot state = test::blank(small);
    state.conc = {test::scatter(24, 0, 1, 1), test::scatter(24, 0, 1, 2)};
    state.diff = {Values(24, 0.1), Values(24, 0.02)};
    const auto grown = test::start(small, state);
    grown->advance(5);
    growable(*grown).expand({true, {0, 5, 2, 3}});
    const Snapshot middle = grown->read();

    const auto large = test::start(two_chemicals(7, 4), middle);
    grown->advance(20);
    large->advance(20);

    CHECK(test::spread(middle.conc[0]) > 1.2 * test::spread(grown->read().conc[0]));
    CHECK(test::same(grown->read(), large->read()));
}

TEST_CASE("picks that do not fit are refused") {
    const Experiment experiment = two_chemicals(4, 3);
    const auto tissue = test::start(experiment, test::blank(experiment));

    CHECK_THROWS_AS(growable(*tissue).expand({true, {0, 0}}), Error);
    CHECK_THROWS_AS(growable(*tissue).expand({true, {0, 0, 4}}), Error);
    CHECK_THROWS_AS(growable(*tissue).expand({false, {0, 0, 0, 3}}), Error);
    CHECK(tissue->cells() == 12);
}
