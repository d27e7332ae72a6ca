// See training.hpp.
#include "app/training.hpp"

#include "app/commands.hpp"
#include "app/draw_report.hpp"
#include "app/interrupt.hpp"
#include "app/memory.hpp"
#include "app/named_files.hpp"
#include "app/prepare.hpp"
#include "app/progress.hpp"
#include "app/say.hpp"
#include "core/allowance.hpp"
#include "core/error.hpp"
#include "io/atomic_file.hpp"
#include "io/file_bytes.hpp"
#include "io/locked.hpp"
#include "io/network.hpp"
#include "io/sha256.hpp"
#include "learn/checkpoint.hpp"
#include "learn/course.hpp"
#include "learn/results.hpp"
#include "learn/target.hpp"
#include "opencl/learn/learner.hpp"
#include "reference/learn/learner.hpp"

#include <fmt/format.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <utility>

namespace pelage::app {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::size_t recent_steps = 100;  // whose mean loss is told

fs::path model_file(const LearnOptions& options) {
    const fs::path file = options.out.empty() ? options.picture.filename().replace_extension(".npz") : options.out;
    if (file.extension() != ".npz") throw Error(fmt::format("'{}': the model's file must end in .npz", file.string()));
    if (fs::is_directory(file)) throw Error(fmt::format("'{}' is a folder; name a file for the model", file.string()));
    return file;
}

fs::path beside(const fs::path& model, const char* ending) {
    return model.parent_path() / (model.stem().string() + ending);
}

void check_room(const learn::Settings& settings) {
    const double needed = learn::bytes_needed(settings), there = usable_memory();
    if (needed <= there) return;
    throw Error(fmt::format(
        "this training takes up to {}, and {} are free; a smaller --size, --pool, --batch or --memory takes less",
        readable_bytes(needed), readable_bytes(there)));
}

std::unique_ptr<Learner> choose_learner(const LearnOptions& options, const LearningTask& task) {
    if (options.backend == "reference") return reference_learner<float>(task);
    OpenclOptions wanted;
    wanted.device = options.device;
    if (options.backend == "opencl" || options.device) return opencl_learner(task, wanted);
    try {
        return opencl_learner(task, wanted);
    } catch (const Error& error) {
        if (!options.quiet) say(stderr, "note: no OpenCL ({}); the reference learns, slowly\n", error.what());
        return reference_learner<float>(task);
    }
}

// A line now and then: on a terminal the next one replaces it.
class StepLine {
public:
    StepLine(bool quiet, std::uint64_t last, std::uint64_t first)
        : quiet_(quiet), terminal_(isatty(STDERR_FILENO) != 0), last_(last), first_(first) {}
    ~StepLine() { clear(); }
    StepLine(const StepLine&) = delete;
    StepLine& operator=(const StepLine&) = delete;

    void show(std::uint64_t step, double loss) {
        const auto now = Clock::now();
        const std::chrono::duration<double> since = now - shown_;
        if (quiet_ || since.count() < (terminal_ ? 0.1 : 10.0)) return;
        shown_ = now;
        const double seconds = std::chrono::duration<double>(now - start_).count();
        const double a_step = seconds / static_cast<double>(step - first_);
        say(stderr, "{}step {} of {}  loss {:.4g}  {:.3g} s a step  ETA {}{}", terminal_ ? "\r\x1b[K" : "",
            grouped(step), grouped(last_), loss, a_step, clock_time(a_step * static_cast<double>(last_ - step)),
            terminal_ ? "" : "\n");
        drawn_ = terminal_;
    }
    void clear() {
        if (drawn_) say(stderr, "\r\x1b[K");
        drawn_ = false;
    }

private:
    bool quiet_, terminal_, drawn_ = false;
    std::uint64_t last_, first_;
    Clock::time_point start_ = Clock::now(), shown_ = start_;
};

class Training {
public:
    explicit Training(const LearnOptions& options)
        : options_(options), model_(model_file(options)), settings_(options.settings) {
        learn::check(settings_);
        check_room(settings_);
        for (const char* ending : {".npz", ".loss.csv", ".loss.png", ".preview.png", ".checkpoint"})
            keep_inputs("beside the model,", beside(model_, ending), {options.picture}, "the picture that is learned");
        const std::string bytes = read_file(options.picture);
        picture_ = learn::parse_colours(bytes, options.picture.string());
        if (!options.resume && fs::exists(checkpoint()))
            throw Error(
                fmt::format("'{}' is there already: go on from it with --resume, or remove it", checkpoint().string()));
        if (options.resume && !fs::exists(checkpoint()))  // said before programs are compiled
            throw Error(fmt::format("'{}' is not there: there is no training to go on from", checkpoint().string()));
        const LearningTask task = learn::make_task(settings_, picture_);
        window_ =
            learn::window_of(picture_, settings_.shape.side, learn::scale_of(settings_, picture_), 0, settings_.wrap);
        course_ = std::make_unique<learn::Course>(settings_, choose_learner(options, task));
        identity_ = {learn::identity(settings_), sha256(bytes), course_->backend()};
        prepare_folder(model_.parent_path().empty() ? fs::path(".") : model_.parent_path());
    }

    int carry_out() {
        if (options_.resume) resume();
        announce();
        write_preview();
        const Interrupt interrupt;
        StepLine line(options_.quiet, settings_.steps, course_->steps());
        while (course_->steps() < settings_.steps && !Interrupt::came()) {
            const learn::StepRecord record = course_->advance();
            if (std::isnan(record.loss)) tell_of_return(line, record);
            line.show(record.step, learn::recent_loss(course_->records(), recent_steps));
            if (record.step % options_.checkpoint_every == 0) save();
            if (record.step % options_.preview_every == 0) write_results();
        }
        line.clear();
        save();
        write_results();
        draw_curve();
        return tell_end();
    }

private:
    fs::path checkpoint() const { return beside(model_, ".checkpoint"); }

    void resume() {
        learn::Saved saved = learn::read_saved(checkpoint(), settings_.shape, identity_);
        course_->restore(std::move(saved.course), std::move(saved.pool));
        if (course_->steps() >= settings_.steps)
            throw Error(fmt::format("'{}' has {} steps already; --steps says where to end, and is {}",
                                    checkpoint().string(), course_->steps(), settings_.steps));
    }

    void announce() const {
        if (options_.quiet) return;
        const LearningShape& shape = settings_.shape;
        say(stderr, "{} from '{}', {} x {} at {:.3g} pixels a cell, on {}: {} weights, steps {} to {}\n",
            model_.string(), options_.picture.string(), picture_.columns, picture_.rows,
            learn::scale_of(settings_, picture_), course_->backend(), grouped(shape.weights()),
            grouped(course_->steps() + 1), grouped(settings_.steps));
        say(stderr, "seed states have a loss of {:.4g}\n", course_->seed_loss());
    }

    void tell_of_return(StepLine& line, const learn::StepRecord& record) const {
        line.clear();
        if (!options_.quiet)
            say(stderr,
                "note: numbers ran away in step {}; back to the last sound weights, at half the learning rate\n",
                record.step);
    }

    void save() const { learn::write_saved(checkpoint(), identity_, course_->state(), course_->pool()); }

    void write_preview() const {
        write_png(beside(model_, ".preview.png"), learn::preview(window_, settings_.shape, course_->samples()));
    }

    void write_results() const {
        write_network(model_, learn::network_of(settings_.shape, course_->learned()));
        write_file(beside(model_, ".loss.csv"), learn::curve_text(course_->records()));
        write_preview();
    }

    void draw_curve() const {
        if (!plotter_is_there()) return;
        nlohmann::json steps = nlohmann::json::array(), losses = nlohmann::json::array();
        for (const learn::StepRecord& one : course_->records()) {
            if (!std::isfinite(one.loss)) continue;
            steps.push_back(one.step);
            losses.push_back(one.loss);
        }
        const PrivateFolder work(fs::temp_directory_path(), "pelage-learn-");
        const nlohmann::json curve{{"curve", {{"title", model_.filename().string()}, {"x", steps}, {"y", losses}}}};
        write_file(work.path() / "curve.json", curve.dump() + "\n");
        draw_report(work.path() / "curve.json", beside(model_, ".loss.png"));
    }

    int tell_end() const {
        const bool stopped = course_->steps() < settings_.steps;
        if (!options_.quiet) {
            const double loss = learn::recent_loss(course_->records(), recent_steps);
            const double less = static_cast<double>(course_->seed_loss()) / loss;
            say(stderr, "step {}: loss {:.4g}, {:.3g} times {} than of seed states\n", grouped(course_->steps()), loss,
                less < 1 ? 1 / less : less, less < 1 ? "more" : "less");
            if (stopped)
                say(stderr, "stopped; the same command with --resume goes on from '{}'\n", checkpoint().string());
            say("{}\n", model_.string());
        }
        return stopped ? interrupted : success;
    }

    const LearnOptions& options_;
    fs::path model_;
    learn::Settings settings_;
    learn::Colours picture_;
    learn::Window window_;
    std::unique_ptr<learn::Course> course_;
    learn::Identity identity_;
};

}  // namespace

int learn_texture(const LearnOptions& options) { return Training(options).carry_out(); }

}  // namespace pelage::app
