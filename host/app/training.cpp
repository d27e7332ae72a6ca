// See training.hpp.
#include "app/training.hpp"

#include "app/choose_learner.hpp"
#include "app/commands.hpp"
#include "app/failure.hpp"
#include "app/interrupt.hpp"
#include "app/last_will.hpp"
#include "app/memory.hpp"
#include "app/progress.hpp"
#include "app/say.hpp"
#include "app/step_line.hpp"
#include "app/training_files.hpp"
#include "core/allowance.hpp"
#include "core/error.hpp"
#include "io/file_bytes.hpp"
#include "io/sha256.hpp"
#include "learn/checkpoint.hpp"
#include "learn/course.hpp"
#include "learn/results.hpp"
#include "learn/target.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <utility>

namespace pelage::app {

namespace {

constexpr std::size_t recent_steps = 100;  // whose mean loss is told

void check_room(const learn::Settings& settings) {
    const double needed = learn::bytes_needed(settings), there = usable_memory();
    if (needed <= there) return;
    throw Error(fmt::format(
        "this training takes up to {}, and {} are free; a smaller --size, --pool, --batch or --memory takes less",
        readable_bytes(needed), readable_bytes(there)));
}

class Training {
public:
    explicit Training(const LearnOptions& options) : options_(options), settings_(options.settings), files_(options) {
        learn::check(settings_);
        check_room(settings_);
        const std::string bytes = read_file(options.picture);
        picture_ = learn::parse_colours(bytes, options.picture.string());
        const LearnerChoice choice = choose_learner(options);
        files_.claim(options.resume);
        if (!options.quiet) say(stderr, "preparing the picture ...\n");  // seconds, where there are many angles
        const LearningTask task = learn::make_task(settings_, picture_);
        window_ =
            learn::window_of(picture_, settings_.shape.side, learn::scale_of(settings_, picture_), 0, settings_.wrap);
        course_ = std::make_unique<learn::Course>(settings_, build_learner(options, choice, task));
        identity_ = {learn::identity(settings_), sha256(bytes), course_->backend()};
        if (options.resume) resume();
    }

    int carry_out() {
        announce();
        files_.preview(settings_, window_, *course_);
        const Interrupt interrupt;
        line_.emplace(options_.quiet, settings_.steps, course_->steps());
        const std::string ran_away = go_on();
        line_->clear();
        if (std::isnan(recent_loss())) return tell_nothing(ran_away);
        rescued([&] {
            save();
            files_.results(settings_, window_, *course_);
        });
        tell_end(ran_away);
        files_.draw_curve(*course_, options_.quiet);
        return ran_away.empty() ? (stopped() ? interrupted : success) : failed_check;
    }

private:
    void resume() {
        learn::Saved saved = learn::read_saved(files_.checkpoint(), settings_.shape, identity_);
        course_->restore(std::move(saved.course), std::move(saved.pool));
        if (course_->steps() >= settings_.steps)
            throw Error(fmt::format("'{}' has {} steps already; --steps says where to end, and is {}",
                                    files_.checkpoint().string(), course_->steps(), settings_.steps));
        safe_ = course_->steps();
    }

    void announce() const {
        if (options_.quiet) return;
        const LearningShape& shape = settings_.shape;
        say(stderr, "{} from '{}', {} x {} at {:.3g} pixels a cell, on {}: {} weights, steps {} to {}\n",
            files_.model().string(), options_.picture.string(), picture_.columns, picture_.rows,
            learn::scale_of(settings_, picture_), course_->backend(), grouped(shape.weights()),
            grouped(course_->steps() + 1), grouped(settings_.steps));
        say(stderr, "seed states have a loss of {:.4g}\n", course_->seed_loss());
    }

    // To the end, or to a signal; how numbers ran away, where they did for good.
    std::string go_on() {
        try {
            while (stopped() && !Interrupt::came()) step();
        } catch (const learn::RanAway& error) {
            return error.what();
        }
        return {};
    }

    void step() {
        const learn::StepRecord record = advance();
        if (std::isnan(record.loss)) tell_of_return(record);
        line_->show(record.step, recent_loss());
        rescued([&] {
            if (record.step % options_.checkpoint_every == 0) save();
            if (record.step % options_.preview_every == 0) files_.results(settings_, window_, *course_);
        });
    }

    // Where the device fails, what was saved before is named.
    learn::StepRecord advance() {
        try {
            return course_->advance();
        } catch (const learn::RanAway&) {
            throw;
        } catch (const Error& error) {
            line_->clear();
            throw Error(error.what() + safe_so_far());
        }
    }

    void save() {
        files_.save(identity_, *course_);
        safe_ = course_->steps();
    }

    // Writes. Where that cannot be done the training itself is not lost, if its checkpoint can be.
    template <class Write>
    void rescued(Write write) {
        std::string reason = failure_of(write);
        if (reason.empty()) return;
        line_->clear();
        try {
            if (safe_ != course_->steps()) save();
        } catch (const Error&) {
            reason += fmt::format("; the training at step {} could not be saved either", course_->steps());
        }
        throw Error(reason + safe_so_far());
    }

    std::string safe_so_far() const {
        if (!safe_) return {};
        return fmt::format("; step {} is safe in '{}', and the same command with --resume goes on from it", *safe_,
                           files_.checkpoint().string());
    }

    void tell_of_return(const learn::StepRecord& record) {
        line_->clear();
        if (!options_.quiet)
            say(stderr,
                "note: numbers ran away in step {}; back to the last sound weights, at half the learning rate\n",
                record.step);
    }

    // No step was made whose numbers held: there is nothing to be kept.
    int tell_nothing(const std::string& ran_away) const {
        if (course_->records().empty()) {
            say(stderr, "pelage: stopped before the first step; nothing was trained yet\n");
            return interrupted;
        }
        if (ran_away.empty())
            say(stderr,
                "pelage: numbers ran away in every step, nothing was learned; a smaller --rate or --iterations may "
                "help\n");
        else
            say(stderr, "pelage: {}; nothing was learned\n", ran_away);
        return failed_check;
    }

    void tell_end(const std::string& ran_away) const {
        const double loss = recent_loss(), less = static_cast<double>(course_->seed_loss()) / loss;
        if (!options_.quiet)
            say(stderr, "step {}: loss {:.4g}, {:.3g} times {} than of seed states\n", grouped(course_->steps()), loss,
                less < 1 ? 1 / less : less, less < 1 ? "more" : "less");
        if (!ran_away.empty())
            say(stderr, "pelage: {}; the last sound weights are in '{}'\n", ran_away, files_.model().string());
        else if (stopped())
            say(stderr, "pelage: stopped at step {}; the same command with --resume goes on from '{}'\n",
                course_->steps(), files_.checkpoint().string());
        if (!options_.quiet) say("{}\n", files_.model().string());
    }

    bool stopped() const { return course_->steps() < settings_.steps; }
    double recent_loss() const { return learn::recent_loss(course_->records(), recent_steps); }

    const LearnOptions& options_;
    learn::Settings settings_;
    TrainingFiles files_;
    learn::Colours picture_;
    learn::Window window_;
    std::unique_ptr<learn::Course> course_;
    learn::Identity identity_;
    std::optional<StepLine> line_;
    std::optional<std::uint64_t> safe_;  // the step of the latest checkpoint
};

}  // namespace

int learn_texture(const LearnOptions& options) {
    when_killed_say(options.resume ? "pelage: stopped before the next step; the checkpoint is as it was\n"
                                   : "pelage: stopped before the first step; nothing was trained yet\n");
    return Training(options).carry_out();
}

}  // namespace pelage::app
