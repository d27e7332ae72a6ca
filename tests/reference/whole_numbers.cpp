// Comparisons of whole numbers: exact up to the largest iteration, in float too.
#include "reference/lab.hpp"

#include <catch2/catch.hpp>

#include <cstdint>
#include <limits>
#include <vector>

using namespace pelage;
using Values = std::vector<double>;

namespace {

const Comparison all[] = {Comparison::equal,      Comparison::not_equal, Comparison::less,
                          Comparison::less_equal, Comparison::greater,   Comparison::greater_equal};

bool truth(double left, Comparison comparison, double right) {
    switch (comparison) {
        case Comparison::equal:
            return left == right;
        case Comparison::not_equal:
            return left != right;
        case Comparison::less:
            return left < right;
        case Comparison::less_equal:
            return left <= right;
        case Comparison::greater:
            return left > right;
        default:
            return left >= right;
    }
}

Operand quantity(Quantity what) { return {what, 0.0, 0}; }

// Where the condition holds in the iteration after `state`: 1, else 0.
Values held(const Condition& condition, const Snapshot& state, Precision precision) {
    Experiment experiment = test::matrix(state.columns, state.rows);
    experiment.rules = {test::rule(Set{Target::concentration, 0, test::number(0)}),
                        test::rule(Set{Target::concentration, 0, test::number(1)}, condition)};
    return test::after(1, experiment, state, precision).conc[0];
}

Snapshot at(std::uint64_t iteration, std::size_t cells = 1) {
    Snapshot state = test::blank(test::matrix(cells, 1));
    state.iteration = iteration;
    return state;
}

}  // namespace

TEST_CASE("an iteration equals itself and no other, however late") {
    const Precision precision = GENERATE(Precision::single_, Precision::double_);
    for (const std::uint64_t now : {std::uint64_t{16777216}, std::uint64_t{16777217}, std::uint64_t{2147483647},
                                    std::uint64_t{2147483649}, largest_iteration - 1}) {
        for (const double number : {-1.0, 0.0, 16777216.5, 16777217.0, 2147483648.0, 2147483649.0, 4294967294.0,
                                    4294967295.0, 4294967295.5, 4294967296.0, 1e30}) {
            for (const Comparison comparison : all) {
                CAPTURE(now, number, static_cast<int>(comparison));
                const Operand iteration = quantity(Quantity::iteration);
                const auto is = static_cast<double>(now);
                CHECK(held(test::compare(iteration, comparison, test::number(number)), at(now), precision)[0] ==
                      truth(is, comparison, number));
                CHECK(held(test::compare(test::number(number), comparison, iteration), at(now), precision)[0] ==
                      truth(number, comparison, is));
            }
        }
    }
}

TEST_CASE("ages, births, rows and counts are compared exactly with each other and within intervals") {
    const Precision precision = GENERATE(Precision::single_, Precision::double_);
    Snapshot state = at(4294967290, 4);
    state.birth = {4294967290u, 2147483645u, 16777217u, 0u};  // ages 0, 2147483645, 4278190073, 4294967290
    state.neighbours = {0, 2, 3, 8};
    const Operand age = quantity(Quantity::age), birth = quantity(Quantity::birth);
    const auto where = [&](const Condition& condition) { return held(condition, state, precision); };

    CHECK(where(test::compare(birth, Comparison::equal, age)) == Values{0, 1, 0, 0});
    CHECK(where(test::compare(birth, Comparison::greater, age)) == Values{1, 0, 0, 0});
    CHECK(where(test::compare(age, Comparison::equal, test::number(4278190073))) == Values{0, 0, 1, 0});
    CHECK(where(Within{birth, test::number(16777216.5), test::number(2147483645)}) == Values{0, 1, 1, 0});
    CHECK(where(Within{birth, test::number(16777218), age}) == Values{0, 1, 0, 0});
    CHECK(where(Within{age, birth, quantity(Quantity::iteration)}) == Values{0, 1, 1, 1});
    CHECK(where(Within{test::number(2.5), quantity(Quantity::neighbours), test::number(3)}) == Values{1, 1, 0, 0});
    CHECK(where(test::compare(quantity(Quantity::neighbours), Comparison::less, test::number(2.5))) ==
          Values{1, 1, 0, 0});
    CHECK(where(test::compare(quantity(Quantity::column), Comparison::greater_equal, quantity(Quantity::rows))) ==
          Values{0, 1, 1, 1});
}
