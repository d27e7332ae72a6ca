// What computes a training: chosen before anything is made, built when the training is sure to be wanted.
#pragma once

#include "app/training.hpp"
#include "core/learning.hpp"
#include "opencl/device/options.hpp"

#include <memory>
#include <optional>

namespace pelage::app {

struct LearnerChoice {
    std::optional<OpenclOptions> opencl;  // none: the reference
    bool asked = false;                   // for OpenCL: nothing else may take its place
};

// As in a run: OpenCL where a device is usable, else the reference; a backend or device that was asked for and cannot
// be had is an Error.
LearnerChoice choose_learner(const LearnOptions&);

// Compiles what there is to compile, and says so before.
std::unique_ptr<Learner> build_learner(const LearnOptions&, const LearnerChoice&, const LearningTask&);

}  // namespace pelage::app
