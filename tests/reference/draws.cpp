// Random numbers during a run: within their range, as likely as stated, and independent of one another.
#include "core/philox.hpp"
#include "lab.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace {

using namespace pelage;

constexpr std::size_t side = 100;
constexpr double cells = side * side;

// The one chemical after an iteration of these rules from 0.
std::vector<double> drawn(const std::vector<Rule>& rules, Precision precision = Precision::double_) {
    Experiment experiment = test::matrix(side, side);
    experiment.rules = rules;
    return test::after(1, experiment, test::blank(experiment), precision).conc[0];
}

Rule random_value() { return test::rule(Set{Target::concentration, 0, {Quantity::random}}); }

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
    const double mean_a = test::sum(a) / cells, mean_b = test::sum(b) / cells;
    double ab = 0, aa = 0, bb = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        ab += (a[i] - mean_a) * (b[i] - mean_b);
        aa += (a[i] - mean_a) * (a[i] - mean_a);
        bb += (b[i] - mean_b) * (b[i] - mean_b);
    }
    return ab / std::sqrt(aa * bb);
}

}  // namespace

TEST_CASE("RANDOM is uniform in 0 to 1") {
    for (const Precision precision : {Precision::single_, Precision::double_}) {
        const std::vector<double> values = drawn({random_value()}, precision);

        std::array<double, 20> bins{};
        for (const double value : values) {
            REQUIRE(value >= 0.0);
            REQUIRE(value < 1.0);
            bins[static_cast<std::size_t>(value * 20)] += 1;
        }
        double chi_square = 0;
        for (const double count : bins) chi_square += (count - cells / 20) * (count - cells / 20) / (cells / 20);
        CHECK(chi_square < 43.8);  // 19 degrees of freedom: passed by 999 of 1000
        CHECK(chi_square > 5.4);   // and not too even
    }
}

TEST_CASE("float and double draw the same numbers") {
    CHECK(drawn({random_value()}, Precision::single_) == drawn({random_value()}, Precision::double_));
}

TEST_CASE("a RANDOM is the documented word of the documented counter") {
    Experiment experiment = test::matrix(3, 2);
    experiment.seed = 0x123456789abcdef;
    const Rule idle = test::rule(Change{Target::concentration, 0, test::number(0), 0.0});
    experiment.rules = {idle, random_value()};

    const Snapshot end = test::after(8, experiment, test::blank(experiment));

    const auto words = philox4x32_10({4, 7, 1, purpose::operand}, {0x89abcdef, 0x01234567});
    CHECK(end.conc[0][4] == unit_uniform<double>(words[0]));
}

TEST_CASE("every RANDOM of a rule, every rule, cell and iteration draws anew") {
    const Condition different = test::compare({Quantity::random}, Comparison::less, {Quantity::random});
    const std::vector<double> pairs =
        drawn({test::rule(Change{Target::concentration, 0, test::number(1), 0.0}, different)});
    CHECK(test::sum(pairs) == Approx(cells / 2).margin(4 * std::sqrt(cells) / 2));

    const std::vector<double> first = drawn({random_value()});
    const std::vector<double> second = drawn({random_value(), random_value()});
    CHECK(std::abs(correlation(first, second)) < 4 / std::sqrt(cells));

    std::vector<double> shifted = first;
    std::rotate(shifted.begin(), shifted.begin() + 1, shifted.end());
    CHECK(std::abs(correlation(first, shifted)) < 4 / std::sqrt(cells));

    Experiment experiment = test::matrix(side, side);
    experiment.rules = {random_value()};
    const std::vector<double> later = test::after(2, experiment, test::blank(experiment)).conc[0];
    CHECK(std::abs(correlation(first, later)) < 4 / std::sqrt(cells));
}

TEST_CASE("a model with more than four RANDOM parameters draws each on its own") {
    Experiment experiment = test::matrix(side, side, Boundary::wrap, Stencil::nine_point, {"U", "V"});
    React react{model_named("linear"), {0, 1}, test::number(1), std::vector<Operand>(10, test::number(0))};
    react.parameters[2] = {Quantity::random};  // cu and cv
    react.parameters[7] = {Quantity::random};
    react.parameters[4] = react.parameters[9] = test::number(1);
    for (const std::size_t i : {0u, 1u, 5u, 6u}) react.parameters[i] = {Quantity::random};
    experiment.rules = {test::rule(react)};

    const Snapshot end = test::after(1, experiment, test::blank(experiment));

    // U is the third draw, V the sixth: word 1 of the second counter.
    const auto later = philox4x32_10({17, 0, 0, purpose::operand + 16}, {1, 0});
    const auto first = philox4x32_10({17, 0, 0, purpose::operand}, {1, 0});
    CHECK(end.conc[0][17] == unit_uniform<double>(first[2]));
    CHECK(end.conc[1][17] == unit_uniform<double>(later[1]));
    CHECK(std::abs(correlation(end.conc[0], end.conc[1])) < 4 / std::sqrt(cells));
}

TEST_CASE("probability holds as often as stated") {
    for (const double chance : {0.0, 0.01, 0.3, 0.5, 0.99, 1.0}) {
        const std::vector<double> hits = drawn(
            {test::rule(Change{Target::concentration, 0, test::number(1), 0.0}, Probability{test::number(chance)})});

        const double deviation = std::sqrt(cells * chance * (1 - chance));  // binomial
        CHECK(std::abs(test::sum(hits) - cells * chance) <= 4 * deviation);
        CHECK(std::all_of(hits.begin(), hits.end(), [](double hit) { return hit == 0.0 || hit == 1.0; }));
    }
}

TEST_CASE("change with a deviation stays within it and fills it") {
    for (const Precision precision : {Precision::single_, Precision::double_}) {
        const std::vector<double> changes =
            drawn({test::rule(Change{Target::concentration, 0, test::number(2), 0.5})}, precision);

        const auto [low, high] = std::minmax_element(changes.begin(), changes.end());
        CHECK(*low >= 1.5);
        CHECK(*low < 1.51);
        CHECK(*high < 2.5);
        CHECK(*high > 2.49);
        CHECK(test::sum(changes) / cells == Approx(2.0).margin(4 * 0.5 / std::sqrt(3 * cells)));
    }
}
