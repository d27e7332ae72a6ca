// See runner.hpp.
#include "app/runner.hpp"
#include "core/searching.hpp"

#include "app/commands.hpp"
#include "app/film.hpp"
#include "app/film_plan.hpp"
#include "app/finite_guard.hpp"
#include "app/interrupt.hpp"
#include "app/machine.hpp"
#include "app/memory.hpp"
#include "app/prepare.hpp"
#include "app/progress.hpp"
#include "app/read_experiment.hpp"
#include "app/recorder.hpp"
#include "app/say.hpp"
#include "app/self_check.hpp"
#include "app/timetable.hpp"
#include "app/tuning.hpp"
#include "core/allowance.hpp"
#include "core/error.hpp"
#include "core/prepattern.hpp"
#include "io/locked.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <new>
#include <type_traits>
#include <vector>

namespace pelage::app {

namespace {

Timetable timetable(const RunOptions& options, const Prepared& prepared) {
    return {prepared.last, prepared.experiment.snap_at, options.snap_every, options.checkpoint_every};
}

class Run {
public:
    Run(const RunOptions& options, const Prepared& prepared, const Machine& machine, std::optional<FilmPlan> film,
        Tissue& tissue)
        : options_(options),
          experiment_(prepared.experiment),
          tissue_(tissue),
          guard_(tissue),
          times_(timetable(options, prepared)),
          progress_(Progress::fitting_style(options.quiet), prepared.last),
          recorder_(options, prepared.experiment, machine, prepared.resumed_at, prepared.last,
                    [this](const std::string& file, bool large) { progress_.writing(file, large); }),
          film_plan_(std::move(film)) {
        tally_.started_at = tissue.iteration();
        if (!recorder_.warning().empty()) tell("pelage: warning: {}\n", recorder_.warning());
    }

    int carry_out() {
        const Interrupt interrupt;
        if (const auto breakdown = rescuing([&] { return guard_.look(); })) return stop_broken(*breakdown);
        if (film_plan_) film_.emplace(*film_plan_, tissue_, recorder_.drawing());
        try {
            return go_on();
        } catch (const Error&) {
            (void)end_film();  // what has been filmed is worth keeping
            throw;
        }
    }

private:
    int go_on() {
        if (tissue_.iteration() == 0) write_due(0);
        while (tissue_.iteration() < times_.last) {
            if (Interrupt::came()) return stop_interrupted();
            if (const auto breakdown = rescuing([&] { return batch(); })) return stop_broken(*breakdown);
            check_film();
            write_due(tissue_.iteration());
        }
        return finish();
    }

    template <class... Words>
    void tell(fmt::format_string<Words...> format, Words&&... words) {
        if (options_.quiet) return;
        progress_.clear();
        say(stderr, format, std::forward<Words>(words)...);
    }

    std::optional<Breakdown> batch() {
        using Clock = std::chrono::steady_clock;
        const std::uint64_t first = tissue_.iteration();
        const std::uint64_t end = first + std::min(size_.iterations(), times_.next_stop(first) - first);
        const auto cells_before = static_cast<double>(tissue_.cells());
        const auto start = Clock::now();
        const double filmed = film_ ? film_->waited() : 0;
        advance_to(end, start);
        const std::uint64_t count = tissue_.iteration() - first;
        const auto breakdown = guard_.look();  // waits for the device
        sample_search(static_cast<double>(tissue_.cells()) > cells_before);
        const double waited = film_ ? film_->waited() - filmed : 0;
        const double seconds = std::chrono::duration<double>(Clock::now() - start).count() - waited;
        size_.took(count, seconds);
        tally_.seconds += seconds;
        tally_.notes = tissue_.report();
        tally_.programs = tissue_.programs();
        tally_.updates += static_cast<double>(count) * (cells_before + static_cast<double>(tissue_.cells())) / 2;
        progress_.show(experiment_.phase_at(first).name, tissue_.iteration(), tally_.updates);
        return breakdown;
    }

    // Frame by frame where there is a film; then it may come to its turn of writing, and a batch ends early.
    void advance_to(std::uint64_t end, std::chrono::steady_clock::time_point start) {
        if (!film_) return tissue_.advance(end - tissue_.iteration());
        const auto latest = start + std::chrono::duration<double>(BatchSize::target);
        do {
            const std::uint64_t frame = film_->plan().next(tissue_.iteration());
            tissue_.advance(std::min(end, frame) - tissue_.iteration());
            if (tissue_.iteration() == frame) film_->take(tissue_);
        } while (tissue_.iteration() < end && std::chrono::steady_clock::now() < latest);
    }

    // A sample costs about one exact search, so one a batch.
    void sample_search(bool growing) {
        if (options_.neighbour_search() != NeighbourSearch::spatial_sorting) return;
        const auto found = search_statistics(tissue_);
        if (!found) return;
        tally_.search += *found;
        if (growing) tally_.growing += *found;
    }

    void check_film() {
        const std::string failure = film_ ? film_->failure() : "";
        if (!failure.empty()) guarded(read(), [&] { throw Error(failure); });
    }

    // What went wrong; empty: nothing.
    std::string end_film() {
        if (!film_) return {};
        std::string failure;
        try {
            progress_.writing(options_.video.file.filename().string(), false);
            film_->end();
            tally_.frames = film_->frames();
            tally_.film_seconds = film_->waited();
        } catch (const Error& error) {
            failure = error.what();
        }
        progress_.clear();
        film_.reset();
        return failure;
    }

    void write_due(std::uint64_t iteration) {
        const bool snapshot = times_.snapshot_at(iteration);
        const bool checkpoint = times_.checkpoint_at(iteration) && iteration < times_.last;
        if (!snapshot && !checkpoint) return;
        const Snapshot state = read();
        guarded(state, [&] {
            if (snapshot) recorder_.snapshot(state);
            if (checkpoint) recorder_.checkpoint(state);
            if (checkpoint) safe_ = state.iteration;
        });
    }

    // When results cannot be written the run itself need not be lost.
    template <class Write>
    void guarded(const Snapshot& state, Write write) {
        std::string reason;
        try {
            return write();
        } catch (const Error& error) {
            reason = error.what();
        } catch (const std::bad_alloc&) {
            reason = "there is not enough memory to write the results";
        }
        progress_.clear();
        if (tissue_.iteration() == tally_.started_at) throw Error(reason);
        std::filesystem::path saved;
        try {
            saved = recorder_.checkpoint(state);
        } catch (const Error&) {
            throw Error(
                fmt::format("{}; the state at iteration {} could not be saved either", reason, state.iteration));
        }
        throw Error(fmt::format("{}; the state at iteration {} is safe, go on with:\n  {}", reason, state.iteration,
                                resume_command(options_, saved, state.iteration, experiment_.run_seed())));
    }

    Snapshot read() {
        return rescuing([&] { return tissue_.read(); });
    }

    // When the device fails, the latest state that is at hand is saved.
    template <class Work>
    std::invoke_result_t<Work> rescuing(Work work) {
        try {
            return work();
        } catch (const Error& error) {
            progress_.clear();
            throw Error(error.what() + rescue());
        }
    }

    std::string rescue() {
        const std::optional<Snapshot>& kept = guard_.kept();
        const std::filesystem::path checkpoint = recorder_.folder() / "checkpoint.pelage";
        if (kept && kept->iteration > safe_.value_or(tally_.started_at)) {
            try {
                recorder_.checkpoint(*kept);
                safe_ = kept->iteration;
            } catch (const Error&) {
                if (!safe_)
                    return fmt::format("; the state at iteration {} could not be saved either", kept->iteration);
            }
        }
        if (!safe_) return {};
        return fmt::format("; the state at iteration {} is safe, go on with:\n  {}", *safe_,
                           resume_command(options_, checkpoint, *safe_, experiment_.run_seed()));
    }

    int finish() {
        progress_.clear();
        const Snapshot state = read();
        guarded(state, [&] {
            recorder_.results(state);
            recorder_.settle();
        });
        const std::string film_failure = end_film();
        progress_.clear();
        guarded(state, [&] { recorder_.manifest(state, tally_, "finished"); });
        tell("{} of {} in {:.3g} s: {} million cell-updates a second\n",
             counted(state.iteration - tally_.started_at, "iteration"), counted(state.cells(), "cell"), tally_.seconds,
             megas(tally_.updates_per_second()));
        for (const std::string& note : tally_.notes) {
            if (options_.explain) say("{}\n", note);
        }
        if (options_.explain && tally_.programs) {
            say("{}: {} compiled, {} from the cache\n",
                counted(tally_.programs->compiled + tally_.programs->cached, "program"), tally_.programs->compiled,
                tally_.programs->cached);
        }
        if (!options_.quiet) say("Results are in {}\n", recorder_.folder().string());
        if (!film_failure.empty()) throw Error(film_failure);
        if (!options_.quiet && tally_.frames > 0) say("{}\n", about_film());
        return success;
    }

    std::string about_film() const {
        return fmt::format("The film is {}, {} at {} a second", options_.video.file.string(),
                           counted(tally_.frames, "frame"), options_.video.fps);
    }

    int stop_interrupted() {
        progress_.clear();
        const Snapshot state = read();
        const std::filesystem::path saved = recorder_.checkpoint(state);
        const std::string film_failure = end_film();
        recorder_.manifest(state, tally_, "interrupted");
        if (!film_failure.empty()) say(stderr, "pelage: {}\n", film_failure);
        say(stderr, "pelage: stopped at iteration {}; go on with:\n  {}\n", state.iteration,
            resume_command(options_, saved, state.iteration, experiment_.run_seed()));
        return interrupted;
    }

    int stop_broken(const Breakdown& breakdown) {
        progress_.clear();
        const Snapshot state = read();
        const std::filesystem::path saved = recorder_.dump(state);
        recorder_.settle();
        const std::string film_failure = end_film();
        progress_.clear();
        recorder_.manifest(state, tally_, "non-finite");
        if (!film_failure.empty()) say(stderr, "pelage: {}\n", film_failure);
        say(stderr, "pelage: {}: {}; the state is in {}\n", experiment_.source, describe(breakdown, tissue_),
            saved.string());
        return failed_check;
    }

    const RunOptions& options_;
    const Experiment& experiment_;
    Tissue& tissue_;
    FiniteGuard guard_;
    Timetable times_;
    BatchSize size_;
    Progress progress_;
    Recorder recorder_;
    std::optional<FilmPlan> film_plan_;
    std::optional<Film> film_;
    Tally tally_;
    std::optional<std::uint64_t> safe_;  // the iteration of this run's latest checkpoint
};

void announce(const RunOptions& options, const Prepared& prepared, const Machine& machine, const Tissue& tissue) {
    if (options.quiet) return;
    say(stderr, "{}: {}, iterations {} to {}, seed {}\n", prepared.experiment.source, counted(tissue.cells(), "cell"),
        grouped(tissue.iteration()), grouped(prepared.last), prepared.experiment.run_seed());
    say(stderr, "backend: {} ({}), {}\n", machine.kind, machine.device,
        options.precision == Precision::double_ ? "double" : "float");
    if (!machine.why.empty()) say(stderr, "not opencl: {}\n", machine.why);
}

void warn(const RunOptions& options, const Prepared& prepared) {
    if (options.quiet) return;
    std::vector<Warning> warnings = prepared.warnings;
    // An unstable step ends the run with an error of its own.
    if (!options.force) std::erase_if(warnings, [](const Warning& one) { return one.lint == "unstable"; });
    print_warnings(prepared.experiment, warnings);
}

// Whether the device may be trusted with the run; says why not.
bool trusted(const RunOptions& options, const Prepared& prepared, const Machine& machine, const Snapshot& start) {
    if (!machine.opencl || options.no_self_test) return true;
    const auto [fault, note] = self_check(*machine.opencl, machine.info, prepared.experiment, start, prepared.last);
    if (!fault.empty()) say(stderr, "pelage: {}\n", fault);
    if (!note.empty() && !options.quiet) say(stderr, "note: {}\n", note);
    return fault.empty();
}

}  // namespace

int run_experiment(const RunOptions& options) {
    Prepared prepared = prepare(options);
    warn(options, prepared);
    check_formats(options, prepared.experiment);
    Footprint needed = footprint(prepared.experiment, prepared.last, options.precision, prepared.resumed.has_value());
    check_cells(prepared.experiment, needed);
    const std::optional<FilmPlan> film = plan_film(options, prepared.experiment, prepared.last);
    if (film) needed.film = Film::bytes(*film, prepared.experiment, needed.cells);
    Machine machine = choose_machine(options, prepared.experiment, needed);
    check_host_memory(prepared.experiment, needed, worked(machine), usable_memory());
    Snapshot initial = initial_state(prepared.experiment, options.precision);
    if (!options.force) check_stability(prepared.experiment, initial);
    const Snapshot& start = prepared.resumed ? *prepared.resumed : initial;
    if (!trusted(options, prepared, machine, start)) return failed_check;
    prepare_folder(options.folder());
    const FolderLock lock(options.folder());
    prepare_json(options.json);
    if (film) prepare_folder(std::filesystem::absolute(film->file).parent_path());
    check_named_files(options);
    tune_machine(options, prepared, start, machine);
    const std::unique_ptr<Tissue> tissue = machine.backend->make_tissue(prepared.experiment, initial);
    if (prepared.resumed) tissue->write(*prepared.resumed);
    initial = {};  // large ones are half of what a run needs
    prepared.resumed.reset();
    announce(options, prepared, machine, *tissue);
    return Run(options, prepared, machine, film, *tissue).carry_out();
}

}  // namespace pelage::app
