// What is left of a run whose device fails, or whose results cannot be written: the latest state, as a checkpoint.
#pragma once

#include "app/failure.hpp"
#include "app/finite_guard.hpp"
#include "app/progress.hpp"
#include "app/recorder.hpp"
#include "app/run_options.hpp"
#include "core/error.hpp"
#include "core/experiment.hpp"
#include "core/snapshot.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>

namespace pelage::app {

class Rescue {
public:
    // `start`: the iteration at which the run begins. Keeps references to all that it is given.
    Rescue(const RunOptions&, const Experiment&, std::uint64_t start, FiniteGuard&, Recorder&, Progress&);

    void saved(std::uint64_t iteration) { safe_ = iteration; }  // a checkpoint of this iteration was written

    // Writes results. Where they cannot be written the run itself is not lost: saves `state`, and throws Error with the
    // command that goes on from it.
    template <class Write>
    void of_results(const Snapshot& state, Write write) {
        const std::string reason = failure_of(write);
        if (!reason.empty()) give_up(state, reason);
    }

    // Asks the device for something. Where it fails, the latest state that is at hand is saved; throws Error with both.
    template <class Work>
    std::invoke_result_t<Work> of_device(Work work) {
        try {
            return work();
        } catch (const Error& error) {
            progress_.clear();
            throw Error(error.what() + save_latest());
        }
    }

private:
    [[noreturn]] void give_up(const Snapshot&, const std::string& reason);
    std::string save_latest();  // what is to be added to the reason

    const RunOptions& options_;
    const Experiment& experiment_;
    std::uint64_t start_;
    FiniteGuard& guard_;
    Recorder& recorder_;
    Progress& progress_;
    std::optional<std::uint64_t> safe_;  // the iteration of this run's latest checkpoint
};

}  // namespace pelage::app
