// See check.hpp: a whole step of learning, there and back, has the reference's bits.
#include "core/philox.hpp"
#include "opencl/learn/learner.hpp"
#include "reference/learn/learner.hpp"
#include "verify/check.hpp"

#include <fmt/format.h>

namespace pelage::verify {

namespace {

// From -1 to 1.
float drawn_number(std::size_t n, std::uint32_t which) {
    return static_cast<float>(2 * unit_uniform<double>(counted_words(n, 0, 0, which, 11)[0]) - 1);
}

std::vector<float> drawn_numbers(std::size_t count, std::uint32_t which, float scale, float middle = 0) {
    std::vector<float> numbers(count);
    for (std::size_t n = 0; n < count; ++n) numbers[n] = middle + scale * drawn_number(n, which);
    return numbers;
}

// Targets are straight lines: any ascending numbers do. The first rotation is the farthest, the third the nearest.
LearningTask task_of(const LearningShape& shape) {
    LearningTask task;
    task.shape = shape;
    task.directions = drawn_numbers(direction_sets * pyramid_levels * patch_numbers * patch_directions, 1, 0.1f);
    for (std::size_t target = 0; target < direction_sets * shape.rotations; ++target) {
        const float aside = 0.2f * static_cast<float>((3 * (target % shape.rotations) + 4) % 5);
        for (std::size_t list = 0; list < pyramid_levels * patch_directions; ++list) {
            const std::size_t count = shape.level_cells(list / patch_directions);
            const float middle = aside + 0.2f * drawn_number(target * pyramid_levels * patch_directions + list, 2);
            for (std::size_t rank = 0; rank < count; ++rank)
                task.ranked.push_back(middle + 1.6f * (static_cast<float>(rank) / static_cast<float>(count) - 0.5f));
        }
    }
    return task;
}

struct Step {
    LearningLoss<float> loss;
    std::vector<float> states, slopes;
    Learned<float> learned;
};

Step step_of(Learner& learner, const LearningShape& shape) {
    Step step;
    step.learned.weights = drawn_numbers(shape.weights(), 3, 0.5f);
    step.learned.mean = drawn_numbers(shape.weights(), 4, 1e-3f);
    step.learned.square = drawn_numbers(shape.weights(), 5, 5e-5f, 6e-5f);
    learner.write(step.learned);
    step.states = drawn_numbers(shape.states(), 6, 1.1f);  // some of it beyond 1
    step.loss = learner.step(step.states, {5, 3, 1e-3, 4});
    step.slopes = learner.slopes();
    step.learned = learner.read();
    return step;
}

std::vector<float> numbers_of(const std::vector<std::size_t>& whole) { return {whole.begin(), whole.end()}; }

void add_step(Tally& tally, const Step& expected, const Step& found, const std::string& where) {
    add(tally, expected.loss.samples, found.loss.samples, where + "losses");
    add(tally, std::vector{expected.loss.total}, std::vector{found.loss.total}, where + "mean of losses");
    add(tally, numbers_of(expected.loss.rotations), numbers_of(found.loss.rotations), where + "nearest rotations");
    add(tally, expected.states, found.states, where + "states");
    add(tally, expected.slopes, found.slopes, where + "slopes of weights");
    add(tally, expected.learned.weights, found.learned.weights, where + "weights");
    add(tally, expected.learned.mean, found.learned.mean, where + "means of slopes");
    add(tally, expected.learned.square, found.learned.square, where + "means of squared slopes");
}

// work_group: 0, as a training has it.
Outcome check_learning_step(Place& place, const LearningShape& shape, const std::vector<std::size_t>& work_groups) {
    if (place.small()) return {Verdict::skipped, {}, "left out with --small", {}};
    LearningTask task = task_of(shape);
    const Step expected = step_of(*reference_learner<float>(task), shape);
    Outcome outcome;
    for (const std::size_t group : work_groups) {
        OpenclOptions options = place.session().options();
        options.work_group = group;
        // With the last one there is no room for all states: some are computed once more on the way back.
        if (group == work_groups.back()) task.memory = 4 * shape.states() * sizeof(float);
        add_step(outcome.tally, expected, step_of(*opencl_learner(task, options), shape),
                 group == 0 ? "" : fmt::format("work-group {}, ", group));
    }
    conclude(outcome);
    return outcome;
}

}  // namespace

std::vector<Check> learn_checks() {
    return {{"learning/rotations", "learning", true,  // more cells in a run than are on their way at a time
             [](Place& place) {
                 return check_learning_step(place, {48, 2, 4, 8, 3}, {0, 16});
             }},
            {"learning/one-rotation", "learning", false,
             [](Place& place) {
                 // A simulator that looks for races shall see the kernels of processors, too.
                 const std::size_t first = place.device().watches_memory() ? 1 : 0;
                 return check_learning_step(place, {32, 1, 4, 8, 1}, {first, 16});
             }},
            {"learning/chemicals", "learning", false,
             [](Place& place) {
                 return check_learning_step(place, {32, 2, 8, 16, 2}, {0, 16});
             }},
            {"learning/many", "learning", false,  // more cells than 15 bits count
             [](Place& place) {
                 return check_learning_step(place, {192, 1, 4, 8, 1}, {0, 16});
             }},
            {"learning/wide", "learning", false,  // more weights than 15 bits count
             [](Place& place) {
                 return check_learning_step(place, {32, 1, 64, 256, 1}, {0, 16});
             }},
            {"learning/uneven", "learning", false, [](Place& place) {
                 return check_learning_step(place, {48, 1, 4, 24, 2}, {0, 32});
             }}};
}

}  // namespace pelage::verify
