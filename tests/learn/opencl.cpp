// Steps of learning on OpenCL: the bits of the float reference, and near the double one.
#include "learn/small.hpp"
#include "opencl/learn/learner.hpp"
#include "reference/learn/learner.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <cstring>
#include <tuple>

using namespace pelage;

namespace {

template <class T>
struct Outcome {
    LearningLoss<T> loss;
    std::vector<T> states, slopes;
    Learned<T> learned;
};

template <class T>
Outcome<T> outcome(LearnerOf<T>& learner, const LearningShape& shape, const LearningOrder& order) {
    Outcome<T> found;
    learner.write(test::small_weights<T>(shape));
    found.states = test::small_states<T>(shape);
    found.loss = learner.step(found.states, order);
    found.slopes = learner.slopes();
    found.learned = learner.read();
    return found;
}

bool same_bits(const std::vector<float>& a, const std::vector<float>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
}

void check_equal(const Outcome<float>& found, const Outcome<float>& expected) {
    CHECK(same_bits(found.loss.samples, expected.loss.samples));
    CHECK(found.loss.total == expected.loss.total);
    CHECK(found.loss.rotations == expected.loss.rotations);
    CHECK(same_bits(found.states, expected.states));
    CHECK(same_bits(found.slopes, expected.slopes));
    CHECK(same_bits(found.learned.weights, expected.learned.weights));
    CHECK(same_bits(found.learned.mean, expected.learned.mean));
    CHECK(same_bits(found.learned.square, expected.learned.square));
}

double far(const std::vector<float>& found, const std::vector<double>& expected) {
    double wrong = 0, all = 0;
    for (std::size_t n = 0; n < expected.size(); ++n) {
        wrong += std::pow(static_cast<double>(found[n]) - expected[n], 2);
        all += expected[n] * expected[n];
    }
    return std::sqrt(wrong / all);
}

}  // namespace

TEST_CASE(
    "a step of learning has the reference's bits, whatever the width, however many share the work and states are "
    "kept") {
    LearningTask task = test::small_task(2, 3);
    const LearningOrder order{7, 3, 1e-3, 4};
    const auto expected = outcome(*reference_learner<float>(task), task.shape, order);
    REQUIRE(std::isfinite(expected.loss.total));
    REQUIRE_FALSE(same_bits(expected.learned.weights, test::small_weights<float>(task.shape).weights));
    OpenclOptions options;
    std::tie(options.width, options.work_group) = GENERATE(table<std::size_t, std::size_t>({{0, 0}, {1, 0}, {1, 48}}));
    task.memory = options.width == 1 ? 0 : std::size_t{1} << 30;
    check_equal(outcome(*opencl_learner(task, options), task.shape, order), expected);
}

TEST_CASE("learned in single precision, slopes are those of double precision but for rounding") {
    const LearningTask task = test::small_task(2, 3);
    const LearningOrder order{7, 3, 1e-3, 4};
    const auto exact = outcome(*reference_learner<double>(task), task.shape, order);
    const auto found = outcome(*opencl_learner(task), task.shape, order);
    CHECK(found.loss.rotations == exact.loss.rotations);
    CHECK(far(found.slopes, exact.slopes) < 1e-3);
    CHECK(far(found.learned.weights, exact.learned.weights) < 1e-5);
}
