// The reference's way back: slopes along states and weights against central differences, in double.
#include "learn/small.hpp"
#include "reference/learn/iteration.hpp"
#include "reference/learn/learner.hpp"
#include "reference/learn/loss.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <functional>

using namespace pelage;
using Numbers = std::vector<double>;

namespace {

// The slope of f along numbers[n], by two values.
double difference(const std::function<double(const Numbers&)>& f, Numbers numbers, std::size_t n, double step) {
    const double at = numbers[n];
    numbers[n] = at + step;
    const double above = f(numbers);
    numbers[n] = at - step;
    return (above - f(numbers)) / (2 * step);
}

// The length of what differs as a share of the length of the slopes, over every `stride`-th place.
double relative_error(const std::function<double(const Numbers&)>& f, const Numbers& at, const Numbers& slopes,
                      std::size_t stride, double step) {
    double wrong = 0, all = 0;
    for (std::size_t n = 0; n < at.size(); n += stride) {
        const double apart = difference(f, at, n, step) - slopes[n];
        wrong += apart * apart;
        all += slopes[n] * slopes[n];
    }
    REQUIRE(all > 0);
    return std::sqrt(wrong / all);
}

double product(const Numbers& a, const Numbers& b) {
    double sum = 0;
    for (std::size_t n = 0; n < a.size(); ++n) sum += a[n] * b[n];
    return sum;
}

}  // namespace

TEST_CASE("the way back through one iteration has the slopes of central differences") {
    const LearningShape shape = test::small_task(1).shape;
    const Numbers x = test::draws<double>(shape.sample(), 2, 1), out = test::draws<double>(shape.sample(), 9, 1);
    const Numbers weights = test::small_weights<double>(shape).weights;
    const auto value = [&](const Numbers& from, const Numbers& with) {
        Numbers y(shape.sample());
        reference::iterate(shape, with, from.data(), y.data());
        return product(out, y);
    };
    Numbers along = out;
    reference::WeightSums<double> sums(shape);
    reference::reverse_iteration(shape, weights, x.data(), along.data(), 0, sums);

    const auto by_state = [&](const Numbers& from) { return value(from, weights); };
    const auto by_weight = [&](const Numbers& with) { return value(x, with); };
    CHECK(relative_error(by_state, x, along, 41, 1e-4) < 1e-8);
    CHECK(relative_error(by_weight, weights, sums.totals(), 1, 1e-4) < 1e-8);
}

TEST_CASE("the loss has the slopes of central differences along the state") {
    const LearningTask task = test::small_task(1);
    const Numbers state = test::small_states<double>(task.shape);
    Numbers slopes(state.size());
    const auto loss = reference::sample_loss(task, 2, state.data(), slopes.data());
    const auto value = [&](const Numbers& at) {
        Numbers unused(at.size());
        return reference::sample_loss(task, 2, at.data(), unused.data()).value;
    };
    CHECK(loss.value > 0);
    // Along lines that change all numbers: one alone changes so little of the loss that rounding would show.
    double wrong = 0, all = 0;
    for (std::uint32_t line = 0; line < 16; ++line) {
        const Numbers along = test::draws<double>(state.size(), 20 + line, 1);
        const auto moved = [&](const Numbers& far) {
            Numbers at = state;
            for (std::size_t n = 0; n < at.size(); ++n) at[n] += far[0] * along[n];
            return value(at);
        };
        const double exact = product(slopes, along);
        wrong += std::pow(difference(moved, {0.0}, 0, 1e-8) - exact, 2);
        all += exact * exact;
    }
    CHECK(std::sqrt(wrong / all) < 1e-6);
}

TEST_CASE("a whole step has the slopes of central differences along every weight, however states are kept") {
    LearningTask task = test::small_task(2);
    const std::size_t memory = GENERATE(std::size_t{1} << 30, std::size_t{0});
    task.memory = memory;
    const auto learner = reference_learner<double>(task);
    const Learned<double> start = test::small_weights<double>(task.shape);
    const LearningOrder order{5, 3, 0.0, 1};
    const auto value = [&](const Numbers& weights) {
        Learned<double> other = start;
        other.weights = weights;
        learner->write(other);
        Numbers states = test::small_states<double>(task.shape);
        return learner->step(states, order).total;
    };
    value(start.weights);
    const Numbers slopes = learner->slopes();
    CHECK(relative_error(value, start.weights, slopes, memory == 0 ? 23 : 5, 1e-7) < 1e-6);
}
