// Candidates of the tuner tried in a child process, which may crash or hang.
#pragma once

#include "app/worker.hpp"
#include "core/experiment.hpp"
#include "opencl/device/device.hpp"
#include "opencl/device/options.hpp"
#include "tune/trial.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pelage::app {

// What is to be tuned: iterations `first` to `last` of an experiment that was read from `file`.
struct TuningJob {
    std::filesystem::path file;
    Experiment experiment;  // with the run's seed
    OpenclOptions options;  // the device by its index
    DeviceInfo device;
    std::uint64_t first = 0;
    std::uint64_t last = 0;
};

class TrialWorker {
public:
    // Of this same program; see worker_arguments.
    explicit TrialWorker(std::vector<std::string> arguments) : arguments_(std::move(arguments)) {}

    // Nothing when no answer came within `whole` seconds, or within `running` of them not counting compilation: the
    // child has been ended then. What a child computes until its candidate has run once counts as compilation, four
    // times over, for others may be at work on the machine, and up to a minute. A child that ends by itself makes the
    // trial Verdict::crashed. The next call starts a new one.
    std::optional<tune::Trial> try_out(const tune::Candidate&, double running, double whole = 86'400);

private:
    std::vector<std::string> arguments_;
    std::unique_ptr<Worker> worker_;
};

std::vector<std::string> worker_arguments(const TuningJob&);

// In the child process: reads candidates and answers each with its trial, until the end of its input.
int answer_candidates(const TuningJob&);

}  // namespace pelage::app
