// Steps of learning by the reference, one thread, in double or single precision.
#pragma once

#include "core/learning.hpp"

#include <memory>

namespace pelage {

template <class T>
std::unique_ptr<LearnerOf<T>> reference_learner(LearningTask);

}  // namespace pelage
