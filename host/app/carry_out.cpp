// See carry_out.hpp.
#include "app/carry_out.hpp"

#include "app/commands.hpp"
#include "app/film.hpp"
#include "app/finite_guard.hpp"
#include "app/interrupt.hpp"
#include "app/progress.hpp"
#include "app/recorder.hpp"
#include "app/rescue.hpp"
#include "app/say.hpp"
#include "app/timetable.hpp"
#include "core/error.hpp"
#include "core/searching.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <utility>

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
          rescue_(options, prepared.experiment, tissue.iteration(), guard_, recorder_, progress_),
          film_plan_(std::move(film)) {
        tally_.started_at = tissue.iteration();
        if (!recorder_.warning().empty()) tell("pelage: warning: {}\n", recorder_.warning());
    }

    int carry_out() {
        const Interrupt interrupt;
        if (const auto breakdown = rescue_.of_device([&] { return guard_.look(); })) return stop_broken(*breakdown);
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
            if (const auto breakdown = rescue_.of_device([&] { return batch(); })) return stop_broken(*breakdown);
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
        size_.took(count, seconds, static_cast<double>(tissue_.cells()) / std::max(1.0, cells_before));
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
        if (!failure.empty()) rescue_.of_results(read(), [&] { throw Error(failure); });
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
        rescue_.of_results(state, [&] {
            if (snapshot) recorder_.snapshot(state);
            if (checkpoint) recorder_.checkpoint(state);
            if (checkpoint) rescue_.saved(state.iteration);
        });
    }

    Snapshot read() {
        return rescue_.of_device([&] { return tissue_.read(); });
    }

    int finish() {
        progress_.clear();
        const Snapshot state = read();
        rescue_.of_results(state, [&] {
            recorder_.results(state);
            recorder_.settle();
        });
        const std::string film_failure = end_film();
        progress_.clear();
        rescue_.of_results(state, [&] { recorder_.manifest(state, tally_, "finished"); });
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
        const std::string what = fmt::format("{}: {}", experiment_.source, describe(breakdown, tissue_));
        try {
            const std::filesystem::path saved = recorder_.dump(state);
            recorder_.settle();
            const std::string film_failure = end_film();
            progress_.clear();
            recorder_.manifest(state, tally_, "non-finite");
            if (!film_failure.empty()) say(stderr, "pelage: {}\n", film_failure);
            say(stderr, "pelage: {}; the state is in {}\n", what, saved.string());
        } catch (const Error& error) {  // what happened is told all the same
            progress_.clear();
            say(stderr, "pelage: {}\npelage: {}\n", what, error.what());
        }
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
    Rescue rescue_;
    std::optional<FilmPlan> film_plan_;
    std::optional<Film> film_;
    Tally tally_;
};

}  // namespace

int carry_out(const RunOptions& options, const Prepared& prepared, const Machine& machine,
              const std::optional<FilmPlan>& film, Tissue& tissue) {
    return Run(options, prepared, machine, film, tissue).carry_out();
}

}  // namespace pelage::app
