// See rescue.hpp.
#include "app/rescue.hpp"

#include <fmt/format.h>

#include <filesystem>

namespace pelage::app {

Rescue::Rescue(const RunOptions& options, const Experiment& experiment, std::uint64_t start, FiniteGuard& guard,
               Recorder& recorder, Progress& progress)
    : options_(options),
      experiment_(experiment),
      start_(start),
      guard_(guard),
      recorder_(recorder),
      progress_(progress) {}

void Rescue::give_up(const Snapshot& state, const std::string& reason) {
    progress_.clear();
    if (state.iteration == start_) throw Error(reason);
    std::filesystem::path checkpoint;
    try {
        checkpoint = recorder_.checkpoint(state);
    } catch (const Error&) {
        throw Error(fmt::format("{}; the state at iteration {} could not be saved either", reason, state.iteration));
    }
    throw Error(fmt::format("{}; the state at iteration {} is safe, go on with:\n  {}", reason, state.iteration,
                            resume_command(options_, checkpoint, state.iteration, experiment_.run_seed())));
}

std::string Rescue::save_latest() {
    const std::optional<Snapshot>& kept = guard_.kept();
    const std::filesystem::path checkpoint = recorder_.folder() / "checkpoint.pelage";
    if (kept && kept->iteration > safe_.value_or(start_)) {
        try {
            recorder_.checkpoint(*kept);
            safe_ = kept->iteration;
        } catch (const Error&) {
            if (!safe_) return fmt::format("; the state at iteration {} could not be saved either", kept->iteration);
        }
    }
    if (!safe_) return {};
    return fmt::format("; the state at iteration {} is safe, go on with:\n  {}", *safe_,
                       resume_command(options_, checkpoint, *safe_, experiment_.run_seed()));
}

}  // namespace pelage::app
