// The reference's parts by hand.
#include "core/error.hpp"
#include "learn/small.hpp"
#include "reference/learn/adam.hpp"
#include "reference/learn/iteration.hpp"
#include "reference/learn/learner.hpp"
#include "reference/learn/loss.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace pelage;

TEST_CASE("an iteration by hand: one hidden value, and diffusion by the share of each quarter") {
    LearningShape shape = test::small_task(1).shape;
    std::vector<double> weights(shape.weights(), 0.0);
    weights[0] = 0.5;                   // W0 of chemical 0 and hidden value 0
    weights[shape.bias()] = 0.25;       // b0
    weights[shape.second() + 3] = 2.0;  // W1 to chemical 3
    std::vector<double> x(shape.sample(), 0.0), y(shape.sample());
    x[5 * 32] = 1.5;  // at the left edge
    reference::iterate(shape, weights, x.data(), y.data());
    const auto act = [](double z) { return z / (1 + std::exp(-5 * z)); };
    CHECK(y[5 * 32] == Approx(1.5 * (1 - 12.0 / 16 / 8)));
    CHECK(y[5 * 32 + 31] == Approx(1.5 * 2.0 / 16 / 8));  // around the edge
    CHECK(y[6 * 32 + 1] == Approx(1.5 * 1.0 / 16 / 8));
    CHECK(y[3 * 1024 + 5 * 32] == Approx(2 * act(1.0)));
    CHECK(y[3 * 1024] == Approx(2 * act(0.25)));
}

TEST_CASE("the loss is 0 at the target, and each sample takes the rotation that is nearest") {
    LearningTask task = test::small_task(1, 3);
    const std::vector<double> state = test::draws<double>(task.shape.sample(), 2, 0.9);
    std::vector<double> slopes(state.size());
    const double before = reference::sample_loss(task, 0, state.data(), slopes.data()).value;
    CHECK(before > 0.01);
    // What the state itself has along the directions becomes the second rotation.
    const std::size_t all = task.shape.level_begin(pyramid_levels) * patch_directions;
    std::vector<double> picture(state.begin(), state.begin() + 3 * 1024);
    std::size_t place = all;
    for (std::size_t level = 0; level < pyramid_levels; ++level) {
        const std::size_t side = task.shape.level_side(level);
        for (std::size_t direction = 0; direction < patch_directions; ++direction) {
            std::vector<double> seen;
            for (std::size_t pixel = 0; pixel < side * side; ++pixel) {
                double sum = 0;
                for (std::size_t number = 0; number < patch_numbers; ++number) {
                    const std::size_t row = (pixel / side + number / 7 % 7) % side,
                                      column = (pixel + number % 7) % side;
                    const std::size_t from = (number / 49 * side + row) * side + column;
                    sum += picture[from] *
                           static_cast<double>(
                               task.directions[(level * patch_numbers + number) * patch_directions + direction]);
                }
                seen.push_back(sum);
            }
            std::ranges::sort(seen);
            for (const double one : seen) task.ranked[place++] = static_cast<float>(one);
        }
        std::vector<double> half(3 * side * side / 4);
        for (std::size_t n = 0; n < half.size(); ++n) {
            const std::size_t from = n / (side / 2) * 2 * side + n % (side / 2) * 2;
            half[n] = (picture[from] + picture[from + 1] + picture[from + side] + picture[from + side + 1]) / 4;
        }
        picture = half;
    }
    const auto after = reference::sample_loss(task, 0, state.data(), slopes.data());
    CHECK(after.rotation == 1);
    CHECK(after.value < 1e-12);
}

TEST_CASE("what lies beyond 1 costs as much as it lies beyond, a cell") {
    LearningTask task = test::small_task(1, 1);
    std::vector<double> state(task.shape.sample(), 0.0), slopes(state.size());
    const double before = reference::sample_loss(task, 0, state.data(), slopes.data()).value;
    CHECK(slopes[3 * 1024 + 7] == 0.0);
    state[3 * 1024 + 7] = -3.5;
    const double after = reference::sample_loss(task, 0, state.data(), slopes.data()).value;
    CHECK(after - before == Approx(2.5 / 1024));
    CHECK(slopes[3 * 1024 + 7] == Approx(-1.0 / 1024));
}

TEST_CASE("the optimiser's first step has the length of the rate along every weight with a slope") {
    const LearningShape shape = test::small_task(1).shape;
    Learned<double> learned;
    learned.weights.assign(shape.weights(), 1.0);
    learned.mean.assign(shape.weights(), 0.0);
    learned.square.assign(shape.weights(), 0.0);
    std::vector<double> slopes = test::draws<double>(shape.weights(), 1, 3.0);
    slopes[5] = 0;
    reference::adam(shape, slopes, 0.01, 1, learned);
    CHECK(learned.weights[5] == 1.0);
    for (const std::size_t n : {std::size_t{0}, std::size_t{7}, shape.bias() + 1, shape.second() + 3})
        CHECK(learned.weights[n] == Approx(slopes[n] > 0 ? 0.99 : 1.01).epsilon(1e-6));
    double length = 0;
    for (std::size_t n = 0; n < shape.bias(); ++n) length += learned.mean[n] * learned.mean[n];
    CHECK(std::sqrt(length) == Approx(0.1));  // of slopes that have length 1
}

TEST_CASE("states are kept as closely as memory allows") {
    CHECK(keeping(64, 1, 100).stride == 1);
    CHECK(keeping(64, 1, 64).states() == 64);
    CHECK(keeping(64, 1, 63).stride == 2);
    CHECK(keeping(64, 1, 20).stride == 4);
    CHECK(keeping(64, 1, 0).states() == 15);
    CHECK(keeping(1, 1, 0).states() == 1);
}

TEST_CASE("shapes that cannot be learned are refused by the name of the option") {
    const auto refused = [](LearningShape shape) {
        try {
            check_learning(shape);
        } catch (const Error& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    CHECK(refused({40, 4, 32, 128, 1}) == "--size 40 is not allowed; allowed is a multiple of 16 from 32 to 512");
    CHECK_THAT(refused({64, 4, 30, 128, 1}), Catch::Contains("--chemicals 30"));
    CHECK_THAT(refused({64, 4, 32, 130, 1}), Catch::Contains("--hidden 130"));
    CHECK(refused({64, 4, 32, 128, 1}).empty());
}
