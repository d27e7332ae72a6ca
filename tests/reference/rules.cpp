// Rules: when they act, what they read, how they combine.
#include "lab.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

namespace {

using namespace pelage;
using Values = std::vector<double>;

const Condition yes = test::compare(test::number(1), Comparison::equal, test::number(1));
const Condition no = test::compare(test::number(1), Comparison::equal, test::number(2));

Change add(double amount, std::size_t chemical = 0) {
    return {Target::concentration, chemical, test::number(amount), 0.0};
}

// Concentration of A in a single cell that starts at 0.
double one_cell(const std::vector<Rule>& rules, std::uint64_t iterations) {
    Experiment experiment = test::matrix(1, 1);
    experiment.rules = rules;
    return test::after(iterations, experiment, test::blank(experiment)).conc[0][0];
}

// What an iteration makes of A = 0 in cells whose B holds `values`.
Values with(const Values& values, const std::vector<Rule>& rules) {
    Experiment experiment = test::matrix(values.size(), 1, Boundary::no_flux, Stencil::nine_point, {"A", "B"});
    experiment.rules = rules;
    Snapshot state = test::blank(experiment);
    state.conc[1] = values;
    return test::after(1, experiment, state).conc[0];
}

Rule scheduled(std::uint64_t from, std::uint64_t until, std::uint64_t every = 1, std::uint64_t offset = 0) {
    Rule result = test::rule(add(1));
    result.from = from;
    result.until = until;
    result.every = every;
    result.offset = offset;
    return result;
}

}  // namespace

TEST_CASE("from and until are inclusive, every and offset periodic") {
    CHECK(one_cell({scheduled(3, 6)}, 3) == 0);
    CHECK(one_cell({scheduled(3, 6)}, 4) == 1);
    CHECK(one_cell({scheduled(3, 6)}, 7) == 4);
    CHECK(one_cell({scheduled(3, 6)}, 20) == 4);
    CHECK(one_cell({scheduled(0, forever, 5)}, 11) == 3);     // 0, 5, 10
    CHECK(one_cell({scheduled(0, forever, 5, 2)}, 12) == 2);  // 2, 7
    CHECK(one_cell({scheduled(6, 12, 5)}, 20) == 1);          // 10
    CHECK(one_cell({scheduled(7, 6)}, 20) == 0);
}

TEST_CASE("comparisons") {
    const Values b{1, 2, 3};
    const auto passes = [&](Comparison comparison) {
        return with(b, {test::rule(add(1), test::compare(Operand::concentration(1), comparison, test::number(2)))});
    };

    CHECK(passes(Comparison::equal) == Values{0, 1, 0});
    CHECK(passes(Comparison::not_equal) == Values{1, 0, 1});
    CHECK(passes(Comparison::less) == Values{1, 0, 0});
    CHECK(passes(Comparison::less_equal) == Values{1, 1, 0});
    CHECK(passes(Comparison::greater) == Values{0, 0, 1});
    CHECK(passes(Comparison::greater_equal) == Values{0, 1, 1});
}

TEST_CASE("within is closed at both ends, a NaN lies nowhere") {
    const Condition within = Within{Operand::concentration(1), test::number(1), test::number(2)};

    CHECK(with({0.5, 1, 1.5, 2, 2.5, std::nan("")}, {test::rule(add(1), within)}) == Values{0, 1, 1, 1, 0, 0});
}

TEST_CASE("rules read the state before the iteration, and their changes add up") {
    const Change twice{Target::concentration, 0, Operand::concentration(0), 0.0};
    CHECK(one_cell({test::rule(add(1)), test::rule(twice), test::rule(add(1))}, 1) == 2);
    CHECK(one_cell({test::rule(add(1)), test::rule(twice), test::rule(add(1))}, 2) == 6);
}

TEST_CASE("and hands its truth to the next rule only") {
    const auto ends = [](const std::vector<Rule>& rules) { return one_cell(rules, 1); };
    const Rule act = test::rule(add(1)), more = test::rule(add(10));

    CHECK(ends({test::rule(And{}, yes), act, more}) == 11);
    CHECK(ends({test::rule(And{}, no), act, more}) == 10);
    CHECK(ends({test::rule(And{}, yes), test::rule(And{}, no), act}) == 0);
    CHECK(ends({test::rule(And{}, no), test::rule(And{}, yes), act}) == 0);
    CHECK(ends({test::rule(And{}, yes), test::rule(And{}, yes), act}) == 1);
    CHECK(ends({test::rule(And{}, yes), test::rule(add(1), no)}) == 0);
}

TEST_CASE("an and outside its interval forbids, a rule outside its own lets the truth drop") {
    Rule late_and = test::rule(And{}, yes), late_rule = test::rule(add(1));
    late_and.from = late_rule.from = 5;
    const Rule act = test::rule(add(10));

    CHECK(one_cell({late_and, act}, 1) == 0);
    CHECK(one_cell({late_and, act}, 6) == 10);
    CHECK(one_cell({test::rule(And{}, yes), late_and, act}, 1) == 0);
    CHECK(one_cell({late_and, test::rule(And{}, yes), act}, 1) == 0);
    CHECK(one_cell({test::rule(And{}, no), late_rule, act}, 1) == 10);
}

TEST_CASE("and joins conditions cell by cell") {
    const auto above = [](double value) {
        return test::compare(Operand::concentration(1), Comparison::greater, test::number(value));
    };
    const auto below = [](double value) {
        return test::compare(Operand::concentration(1), Comparison::less, test::number(value));
    };

    CHECK(with({1, 2, 3, 4, 5}, {test::rule(And{}, above(1)), test::rule(add(1), below(4)),
                                 test::rule(add(5), above(4))}) == Values{0, 1, 1, 0, 5});
}

TEST_CASE("set replaces whatever rules and diffusion made, and bounds still hold") {
    Experiment experiment = test::matrix(3, 1, Boundary::no_flux, Stencil::five_point, {"A", "B"});
    experiment.phases[0].bounds[0] = {0.0, 5.0};
    const Set copy{Target::concentration, 0, Operand::concentration(1)};
    experiment.rules = {
        test::rule(Set{Target::concentration, 0, test::number(3)}),
        test::rule(copy, test::compare(Operand::concentration(1), Comparison::not_equal, test::number(1))),
        test::rule(add(100))};
    Snapshot state = test::blank(experiment);
    state.conc = {{4, 0, 4}, {1, -2, 7}};
    state.diff[0].assign(3, 0.25);

    CHECK(test::after(1, experiment, state).conc[0] == Values{3, 0, 5});
}

TEST_CASE("rates change at once to no less than 0, set comes after all changes, diffusion still runs at the old rate") {
    Experiment experiment = test::matrix(2, 1, Boundary::no_flux, Stencil::five_point);
    const auto change = [](double amount) { return Change{Target::rate, 0, test::number(amount), 0.0}; };
    Snapshot state = test::blank(experiment);
    state.conc[0] = {0, 8};
    state.diff[0].assign(2, 0.25);

    experiment.rules = {test::rule(change(-1)), test::rule(change(0.125))};
    const Snapshot changed = test::after(1, experiment, state);
    experiment.rules = {test::rule(Set{Target::rate, 0, test::number(0.5)}), test::rule(change(0.125))};
    const Snapshot set = test::after(1, experiment, state);
    experiment.rules = {test::rule(Set{Target::rate, 0, test::number(-0.5)})};
    const Snapshot negative = test::after(1, experiment, state);

    CHECK(changed.diff[0] == Values{0.125, 0.125});
    CHECK(changed.conc[0] == Values{2, 6});
    CHECK(set.diff[0] == Values{0.5, 0.5});
    CHECK(negative.diff[0] == Values{0, 0});
}

TEST_CASE("mappings are linear, clamped, per cell, read at once and kept") {
    Experiment experiment = test::matrix(5, 1, Boundary::no_flux, Stencil::nine_point, {"A", "B"});
    experiment.mappings = {"m", "n"};
    const Operand m{Quantity::mapping, 0.0, 0}, n{Quantity::mapping, 0.0, 1};
    Rule first_only = test::rule(Map{Operand::concentration(1), 1.0, 3.0, 0, 10.0, 30.0});
    first_only.until = 0;
    experiment.rules = {first_only, test::rule(Map{m, 10.0, 30.0, 1, 1.0, -1.0}),
                        test::rule(Change{Target::concentration, 0, n, 0.0})};
    Snapshot state = test::blank(experiment);
    state.conc[1] = {0, 1, 1.5, 3, 4};

    const Snapshot one = test::after(1, experiment, state);
    const Snapshot two = test::after(2, experiment, state);

    CHECK(one.mappings[0] == Values{10, 10, 15, 30, 30});
    CHECK(one.mappings[1] == Values{1, 1, 0.5, -1, -1});
    CHECK(one.conc[0] == Values{1, 1, 0.5, -1, -1});
    CHECK(two.mappings[0] == one.mappings[0]);
    CHECK(two.conc[0] == Values{2, 2, 1, -2, -2});
}

TEST_CASE("places, ages and counts as parameters") {
    Experiment experiment = test::matrix(3, 2);
    Snapshot state = test::blank(experiment);
    state.iteration = 7;
    state.birth = {4, 0, 0, 0, 0, 7};
    const auto read = [&](Quantity quantity, std::uint64_t iteration) {
        experiment.rules = {test::rule(Set{Target::concentration, 0, {quantity}})};
        return test::after(iteration + 1, experiment, state).conc[0];
    };

    CHECK(read(Quantity::x, 0) == Values{-2, 0, 2, -2, 0, 2});
    CHECK(read(Quantity::y, 0) == Values{-1, -1, -1, 1, 1, 1});
    CHECK(read(Quantity::column, 0) == Values{0, 1, 2, 0, 1, 2});
    CHECK(read(Quantity::row, 0) == Values{0, 0, 0, 1, 1, 1});
    CHECK(read(Quantity::columns, 0) == Values(6, 3));
    CHECK(read(Quantity::rows, 0) == Values(6, 2));
    CHECK(read(Quantity::iteration, 5) == Values(6, 12));
    CHECK(read(Quantity::birth, 0) == Values{4, 0, 0, 0, 0, 7});
    CHECK(read(Quantity::age, 5) == Values{8, 12, 12, 12, 12, 5});
    CHECK(read(Quantity::neighbours, 0) == Values(6, 0));
    CHECK(read(Quantity::neighbours, 1) == Values{3, 5, 3, 3, 5, 3});
}
