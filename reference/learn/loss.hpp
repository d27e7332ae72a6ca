// How far what has grown is from the target: sliced optimal transport between patches of a picture and of its halves
// and quarters. Patches are seen along random directions; in each, what was seen is brought into ascending order and
// compared, rank by rank, with what the target has there.
#pragma once

#include "core/learning.hpp"

#include <cstddef>
#include <vector>

namespace pelage::reference {

template <class T>
struct SampleLoss {
    T value = 0;
    std::size_t rotation = 0;  // of the target that is nearest
};

// Of one sample, state: [chemical][cell]; slopes, of the same shape: those of the mean over a batch.
template <class T>
SampleLoss<T> sample_loss(const LearningTask&, std::size_t set, const T* state, T* slopes);

}  // namespace pelage::reference
