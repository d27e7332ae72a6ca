// A small thing to learn, with numbers drawn at random.
#pragma once

#include "core/learning.hpp"
#include "core/philox.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace test {

// From -1 to 1, the same everywhere.
inline double draw(std::size_t n, std::uint32_t which) {
    return 2 * pelage::unit_uniform<double>(pelage::counted_words(n, 0, 0, 77 + which, 5)[0]) - 1;
}

template <class T>
std::vector<T> draws(std::size_t count, std::uint32_t which, double scale, double middle = 0) {
    std::vector<T> numbers(count);
    for (std::size_t n = 0; n < count; ++n) numbers[n] = static_cast<T>(middle + scale * draw(n, which));
    return numbers;
}

inline pelage::LearningTask small_task(std::size_t batch = 2, std::size_t rotations = 3) {
    pelage::LearningTask task;
    task.shape = {32, batch, 4, 8, rotations};
    task.directions = draws<float>(
        pelage::direction_sets * pelage::pyramid_levels * pelage::patch_numbers * pelage::patch_directions, 1, 0.1);
    for (std::size_t target = 0; target < pelage::direction_sets * rotations; ++target) {
        for (std::size_t level = 0; level < pelage::pyramid_levels; ++level) {
            for (std::size_t direction = 0; direction < pelage::patch_directions; ++direction) {
                const std::size_t count = task.shape.level_cells(level);
                const double middle = 0.2 * draw(target * 96 + level * 32 + direction, 7);
                for (std::size_t rank = 0; rank < count; ++rank)
                    task.ranked.push_back(static_cast<float>(
                        middle + 1.6 * (static_cast<double>(rank) / static_cast<double>(count) - 0.5)));
            }
        }
    }
    return task;
}

template <class T>
pelage::Learned<T> small_weights(const pelage::LearningShape& shape) {
    pelage::Learned<T> learned;
    learned.weights = draws<T>(shape.weights(), 3, 0.5);
    learned.mean = draws<T>(shape.weights(), 4, 1e-3);
    learned.square = draws<T>(shape.weights(), 6, 5e-5, 6e-5);
    return learned;
}

// Some of it lies beyond 1.
template <class T>
std::vector<T> small_states(const pelage::LearningShape& shape) {
    return draws<T>(shape.states(), 2, 1.1);
}

}  // namespace test
