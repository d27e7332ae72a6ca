// What a training leaves beside its checkpoint: the network, the loss curve, and a picture of what grows.
#pragma once

#include "core/learning.hpp"
#include "core/neural.hpp"
#include "io/picture.hpp"
#include "learn/course.hpp"
#include "learn/picture.hpp"

#include <string>
#include <vector>

namespace pelage::learn {

Network network_of(const LearningShape&, const Learned<float>&);

// A line a step: step,loss,rate,iterations.
std::string curve_text(const std::vector<StepRecord>&);

// The target, and the samples beside it, enlarged.
Picture preview(const Window& target, const LearningShape&, const std::vector<float>& samples);

// The mean loss of the last `count` steps whose numbers did not run away; NaN: there are none.
double recent_loss(const std::vector<StepRecord>&, std::size_t count);

}  // namespace pelage::learn
