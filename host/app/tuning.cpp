// See tuning.hpp.
#include "app/tuning.hpp"

#include "app/own_program.hpp"
#include "app/say.hpp"
#include "app/self_check.hpp"
#include "core/error.hpp"
#include "opencl/backend.hpp"
#include "opencl/device/cache.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <utility>

namespace pelage::app {

namespace {

using tune::Candidate;
using tune::Record;

// What a usual device of its kind does, in cell-updates a second: enough to tell seconds from minutes.
constexpr double usual_speed_cpu = 1e9, usual_speed_other = 2e10;
// Where a search of 5 seconds finds something a third faster, a run of 20 seconds has won them back.
constexpr double search_from_seconds = 20;
// What is remembered costs no search, but programs that may have to be compiled.
constexpr double remember_from_seconds = 2;

std::filesystem::path folder_of(const TuningJob& job) {
    return job.options.use_cache ? cache_folder() : std::filesystem::path();
}

// Why a record is not kept; empty: it is.
std::string kept_nowhere(const TuningJob& job, const Record& record) {
    if (!job.options.use_cache) return "--no-cache";
    return store_record(folder_of(job), record);
}

double since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double usual_seconds(const DeviceInfo& device, const Snapshot& start, std::uint64_t last) {
    const auto iterations = static_cast<double>(last - std::min(last, start.iteration));
    const double speed = device.type == "cpu" ? usual_speed_cpu : usual_speed_other;
    return iterations * static_cast<double>(start.cells()) / speed;
}

std::string percent(double gain) { return fmt::format("{:.0f} % faster than the defaults", 100 * gain); }

std::string told(const Tuning& tuning, const Candidate& chosen) {
    const std::size_t tried = tuning.record.trials.size();
    if (tried == 0)
        return fmt::format("tuning: the defaults (there was no time for others in {:.1f} s)", tuning.seconds);
    const std::string memory =
        tuning.remembered ? "remembered" : fmt::format("{} tried in {:.1f} s", tried, tuning.seconds);
    if (chosen == Candidate{}) return fmt::format("tuning: the defaults ({})", memory);
    const double gain = tuning.record.gain();
    return fmt::format("tuning: {} ({}{})", chosen.text(), memory, gain > 0 ? ", " + percent(gain) : "");
}

TuningJob job_of(const RunOptions& options, const Prepared& prepared, const Snapshot& start, const Machine& machine) {
    return {options.file, prepared.experiment, *machine.opencl, machine.info, start.iteration, prepared.last};
}

// What the self-test finds wrong with a candidate; empty: nothing.
std::string fault_of(const TuningJob& job, const Candidate& candidate, const Snapshot& start) {
    try {
        return self_check(applied(candidate, job.options), job.device, job.experiment, start, job.last).fault;
    } catch (const Error& error) {
        return error.what();
    }
}

// The record's best that passes the self-test with this very experiment; others are struck out.
Candidate proven(const TuningJob& job, const RunOptions& options, const Snapshot& start, Record& record) {
    for (Candidate best = record.best(); best != Candidate{}; best = record.best()) {
        if (options.no_self_test) return best;
        const std::string fault = fault_of(job, best, start);
        if (fault.empty()) return best;
        tune::Trial trial = *record.find(best);
        trial.verdict = tune::Verdict::wrong;
        trial.updates_per_second = 0;
        trial.message = fault;
        record.put(trial);
        (void)store_record(folder_of(job), record);
    }
    return {};
}

class SearchProgress {
public:
    SearchProgress(Shown shown, const tune::Budget& budget)
        : line_(shown != Shown::nothing && isatty(STDERR_FILENO) != 0),
          sentence_(shown == Shown::everywhere && !line_),
          seconds_(budget.whole) {}
    ~SearchProgress() {
        if (drawn_) put(stderr, "\r\x1b[K");
    }
    SearchProgress(const SearchProgress&) = delete;
    SearchProgress& operator=(const SearchProgress&) = delete;

    void show(std::size_t place, std::size_t all, const Candidate& candidate) {
        if (line_) say(stderr, "\r\x1b[Ktuning: [{}/{}] {}", place, all, candidate.text());
        if (std::exchange(sentence_, false))
            say(stderr, "tuning: a faster kernel is looked for, for {:g} seconds at most\n", seconds_);
        drawn_ = line_;
    }

private:
    bool line_;
    bool sentence_;
    double seconds_;
    bool drawn_ = false;
};

}  // namespace

tune::Key key_of(const TuningJob& job) {
    return tune::make_key(job.device, own_checksum(), job.options.precision, job.options.fast, job.experiment);
}

Tuning tuned(const TuningJob& job, tune::Effort effort, const tune::Budget& budget, Shown shown) {
    const auto start = std::chrono::steady_clock::now();
    const std::filesystem::path folder = folder_of(job);
    Tuning tuning;
    tuning.record.key = key_of(job);
    if (auto known = load_record(folder, tuning.record.key)) tuning.record = std::move(*known);
    const bool quick = effort == tune::Effort::quick;
    tuning.remembered = tuning.record.complete && (tuning.record.exhaustive || quick) &&
                        (quick || !has_more_patience(budget, tuning.record));
    if (tuning.remembered) return tuning;
    TrialWorker worker(worker_arguments(job));
    tune::Hands hands;
    hands.try_out = [&](const Candidate& candidate, double running, double whole) {
        return worker.try_out(candidate, running, whole);
    };
    hands.keep = [&](const Record& record) { tuning.not_kept = kept_nowhere(job, record); };
    SearchProgress progress(shown, budget);
    hands.announce = [&](std::size_t place, std::size_t all, const Candidate& candidate) {
        progress.show(place, all, candidate);
    };
    hands.clock = [&] { return since(start); };
    search(tuning.record, candidates(job.device, job.options.precision, effort), effort, budget, hands);
    tuning.seconds = since(start);
    return tuning;
}

namespace {

// Of a run that will take so many seconds on a usual device: searched for, or at least remembered.
std::optional<Tuning> found(const TuningJob& job, double seconds, bool quiet) {
    if (seconds >= search_from_seconds && std::filesystem::is_regular_file(job.file)) {
        return tuned(job, tune::Effort::quick, tune::quick_budget, quiet ? Shown::nothing : Shown::everywhere);
    }
    auto known = load_record(folder_of(job), key_of(job));
    if (!known || !known->complete) return {};
    return Tuning{std::move(*known), true, 0, ""};
}

}  // namespace

void tune_machine(const RunOptions& options, const Prepared& prepared, const Snapshot& start, Machine& machine) {
    if (!machine.opencl || !start.lattice()) return;
    machine.tuning = Candidate{}.text();
    const double seconds = usual_seconds(machine.info, start, prepared.last);
    if (options.no_tune || seconds < remember_from_seconds || machine.info.watches_memory()) return;
    try {
        const TuningJob job = job_of(options, prepared, start, machine);
        std::optional<Tuning> tuning = found(job, seconds, options.quiet);
        if (!tuning) return;
        const Candidate chosen = proven(job, options, start, tuning->record);
        if (!options.quiet) say(stderr, "{}\n", told(*tuning, chosen));
        if (chosen == Candidate{}) return;
        const OpenclOptions own = applied(chosen, *machine.opencl);
        machine.backend = opencl_backend(own);
        machine.opencl = own;
        machine.tuning = chosen.text();
    } catch (const Error& error) {  // the run itself may do well without
        if (!options.quiet) say(stderr, "tuning: the defaults ({})\n", error.what());
    }
}

}  // namespace pelage::app
