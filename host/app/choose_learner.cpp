// See choose_learner.hpp.
#include "app/choose_learner.hpp"

#include "app/machine.hpp"
#include "app/say.hpp"
#include "core/error.hpp"
#include "opencl/device/device.hpp"
#include "opencl/learn/learner.hpp"
#include "reference/learn/learner.hpp"

#include <cstdio>

namespace pelage::app {

namespace {

void tell_of_reference(const LearnOptions& options, const Error& error) {
    if (!options.quiet) say(stderr, "note: no OpenCL ({}); the reference learns, slowly\n", error.what());
}

}  // namespace

LearnerChoice choose_learner(const LearnOptions& options) {
    check_device(options.backend, options.device);
    LearnerChoice choice;
    if (options.backend == "reference") return choice;
    choice.opencl.emplace();
    if (!options.device.empty()) choice.opencl->device = options.device;
    choice.asked = options.backend == "opencl" || !options.device.empty() || variable_chooses_device();
    try {
        (void)select_device(choice.opencl->device);
    } catch (const Error& error) {
        if (choice.asked) throw;
        tell_of_reference(options, error);
        choice.opencl.reset();
    }
    return choice;
}

std::unique_ptr<Learner> build_learner(const LearnOptions& options, const LearnerChoice& choice,
                                       const LearningTask& task) {
    if (!choice.opencl) return reference_learner<float>(task);
    if (!options.quiet) say(stderr, "building kernels ...\n");
    try {
        return opencl_learner(task, *choice.opencl);
    } catch (const Error& error) {
        if (choice.asked) throw;
        tell_of_reference(options, error);
        return reference_learner<float>(task);
    }
}

}  // namespace pelage::app
