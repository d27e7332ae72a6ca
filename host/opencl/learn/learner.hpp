// Steps of learning on an OpenCL device, in single precision: the reference's bits.
#pragma once

#include "core/learning.hpp"
#include "opencl/device/options.hpp"

#include <memory>

namespace pelage {

// Throws Error when there is no such device, or too little memory on it.
std::unique_ptr<Learner> opencl_learner(const LearningTask&, const OpenclOptions& = {});

}  // namespace pelage
