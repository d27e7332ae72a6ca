// See tissue.hpp.
#include "opencl/lattice/tissue.hpp"

#include "core/growable.hpp"
#include "core/schedule.hpp"
#include "opencl/device/cl_error.hpp"
#include "opencl/device/launch.hpp"
#include "opencl/device/program.hpp"
#include "opencl/lattice/choice.hpp"
#include "opencl/lattice/means.hpp"
#include "opencl/lattice/non_finite.hpp"
#include "opencl/lattice/phase_numbers.hpp"
#include "opencl/lattice/state.hpp"
#include "opencl/lattice/step.hpp"
#include "opencl/lattice/stream.hpp"
#include "opencl/lattice/tile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

namespace pelage {

namespace {

class OpenclLattice final : public Growable {
public:
    OpenclLattice(std::shared_ptr<const Session> session, std::shared_ptr<const Experiment> experiment,
                  const Snapshot& initial, MakeStep own_step)
        : Growable(std::move(experiment), initial),
          session_(std::move(session)),
          pace_(*session_),
          own_step_(std::move(own_step)) {
        do_write(initial);
    }

    std::vector<std::string> report() const override { return notes_; }
    std::optional<ProgramCounts> programs() const override { return session_->program_counts(); }

private:
    static constexpr std::size_t most_notes = 64;
    using Key = std::tuple<std::vector<bool>, Path, FusedShape>;  // active rules, and how they are carried out

    std::size_t do_cells() const override { return state_->grid().cells(); }

    void do_advance(std::uint64_t first, std::uint64_t count) override {
        with_device(session_->info().name, [&] {
            const std::uint64_t end = first + count;
            upload_parameters(experiment().phase_at(first));
            for (std::uint64_t iteration = first; iteration < end;) {
                const std::uint64_t next = std::min(end, next_change(experiment(), iteration));
                LatticeKernel& step = step_for(iteration, next - iteration);
                if (!counted_) {  // rules may read the counts: they change after this one iteration
                    step.enqueue(*state_, parameters_, iteration, 1, pace_);
                    state_->counted();
                    counted_ = true;
                    ++iteration;
                }
                step.enqueue(*state_, parameters_, iteration, next - iteration, pace_);
                iteration = next;
            }
            session_->queue().flush();
        });
    }

    void do_expand(const Insertion& insertion) override {
        with_device(session_->info().name, [&] { state_->expand(insertion, iteration()); });
        counted_ = false;
    }

    void do_resample(const Resampling& resampling) override {
        with_device(session_->info().name,
                    [&] { state_->stretch(resampling, experiment().phase_at(iteration()).bounds); });
        counted_ = false;
    }

    void do_set_rate(std::size_t chemical, double rate) override {
        with_device(session_->info().name, [&] { state_->set_rate(chemical, rate); });
    }

    Snapshot do_read() const override {
        return with_device(session_->info().name, [&] { return state_->read(); });
    }

    void do_read_conc(std::size_t chemical, std::vector<float>& to) const override {
        with_device(session_->info().name, [&] { state_->conc().download(state_->grid(), chemical, to); });
    }

    void do_write(const Snapshot& snapshot) override {
        with_device(session_->info().name, [&] {
            const LatticePlan plan = lattice_plan(experiment(), snapshot);
            const std::vector<bool> every(experiment().rules.size(), true);
            every_use_ = emit_rules(experiment(), every, session_->options().precision).use;
            state_ = std::make_unique<LatticeState>(*session_, std::vector<LatticeStart>{{experiment(), snapshot}},
                                                    plan, every_use_);
            if (plan.rates != plan_.rates || plan.polarity != plan_.polarity ||
                plan.layers != plan_.layers) {  // all else is the experiment's
                steps_.clear();
                any_set_.clear();
                known_.clear();
                means_ = nullptr;
            }
            if (means_) means_->forget();
            plan_ = plan;
            counted_ = false;
        });
    }

    std::optional<NonFinite> do_non_finite() const override {
        return with_device(session_->info().name, [&] {
            if (!finder_) finder_.emplace(*session_);
            return finder_->first_in(*state_);
        });
    }

    // The kernel for `count` iterations from `iteration` on.
    LatticeKernel& step_for(std::uint64_t iteration, std::uint64_t count) {
        const std::vector<bool> active = active_rules(experiment(), iteration);
        Known& known = choose_for(active, iteration, count);
        const Choice& choice = known.choice;
        const Key key{active, choice.path, choice.cut};
        if (steps_.size() >= session_->options().variants && !steps_.contains(key)) {
            if (!known.any) known.any = for_any_set(choice);
            const Choice& any = *known.any;
            const std::vector<bool> every(active.size(), true);
            std::unique_ptr<LatticeKernel>& step = any_set_[{every, any.path, any.cut}];
            if (!step) step = make_step(every, true, any, iteration);
            return *step;
        }
        std::unique_ptr<LatticeKernel>& step = steps_[key];
        if (!step) step = make_step(active, false, choice, iteration);
        return *step;
    }

    // What is known of one set of active rules.
    struct Known {
        RuleNeeds needs;
        Work work;
        double chosen_at = 0;  // work.done when the choice was made; 0: not yet
        Choice choice;
        std::optional<Choice> any;  // the same for a program that tests at run time which rules act
    };

    Known& choose_for(const std::vector<bool>& active, std::uint64_t iteration, std::uint64_t count) {
        const auto found = known_.find(active);
        Known& known = found != known_.end() ? found->second : known_.emplace(active, first_look(active)).first->second;
        const auto cells = static_cast<double>(do_cells());
        known.work.done += static_cast<double>(count) * cells;
        constexpr double worth_asking = 1.1;  // little work more changes nothing, and asking takes time too
        const bool stays = known.work.compiled || known.work.done < worth_asking * known.chosen_at;
        if (known.chosen_at > 0 && known.work.cells == cells && stays) return known;
        known.work.cells = cells;
        known.work.ahead = work_ahead(experiment(), active, iteration, cells);
        known.choice = choose(session_->info(), known.needs, known.work, session_->options());
        known.work.compiled = known.choice.path == Path::streamed;
        known.any.reset();
        known.chosen_at = known.work.done;
        return known;
    }

    Known first_look(const std::vector<bool>& active) const {
        const Precision precision = session_->options().precision;
        Known known;
        known.needs = rule_needs(experiment(), plan_, emit_rules(experiment(), active, precision).use);
        known.work.bytes_a_cell = bytes_a_cell(experiment(), plan_, every_use_, precision);
        return known;
    }

    // The same path, cut for a program that tests at run time which rules act.
    Choice for_any_set(const Choice& choice) const {
        OpenclOptions options = session_->options();
        if (choice.path != Path::tiled) options.path = choice.path;  // else it may not fit: then it is not asked for
        Work work;
        work.cells = static_cast<double>(do_cells());
        Choice any = choose(session_->info(), rule_needs(experiment(), plan_, every_use_), work, options);
        any.why = choice.why;
        return any;
    }

    std::unique_ptr<LatticeKernel> make_step(const std::vector<bool>& active, bool test_intervals, const Choice& choice,
                                             std::uint64_t iteration) {
        note(fmt::format("from iteration {}: ", iteration), choice.text());
        if (own_step_) return own_step_(*session_, experiment(), plan_, active, test_intervals, choice);
        if (choice.path == Path::streamed) {
            return std::make_unique<StreamedStep>(*session_, experiment(), plan_, active, test_intervals, choice);
        }
        if (choice.path == Path::tiled) {
            return std::make_unique<TiledStep>(*session_, experiment(), plan_, active, test_intervals, choice);
        }
        if (!means_ && means_pay(*session_, plan_, every_use_)) {
            means_ = std::make_shared<LatticeMeans>(*session_, experiment(), plan_);
        }
        return std::make_unique<LatticeStep>(*session_, experiment(), plan_, active, test_intervals, choice, means_);
    }

    void note(const std::string& when, const std::string& text) {
        if (text == latest_note_ || notes_.size() == most_notes) return;
        notes_.push_back(when + text);
        latest_note_ = text;
    }

    void upload_parameters(const Phase& phase) {
        const Precision precision = session_->options().precision;
        std::vector<KernelNumber> values =
            phase_numbers(experiment(), plan_, state_->uniform_rates(), phase, precision);
        if (rule_parameters_.empty()) rule_parameters_ = rule_parameters(experiment(), precision);
        values.insert(values.end(), rule_parameters_.begin(), rule_parameters_.end());
        const std::vector<std::uint32_t> words = parameter_words(values, precision);
        if (words == parameter_words_) return;
        if (parameters_() == nullptr) parameters_ = session_->buffer(words.size() * sizeof words[0], "parameters");
        session_->queue().enqueueWriteBuffer(parameters_, CL_TRUE, 0, words.size() * sizeof words[0], words.data());
        parameter_words_ = words;
    }

    std::shared_ptr<const Session> session_;
    Pace pace_;
    MakeStep own_step_;  // empty: ours
    LatticePlan plan_;
    RuleUse every_use_;  // what any rule may need, at any time
    std::unique_ptr<LatticeState> state_;
    std::shared_ptr<LatticeMeans> means_;  // null where they do not pay, or not needed yet
    bool counted_ = false;                 // state_ has been told that an iteration has been carried out
    std::map<std::vector<bool>, Known> known_;
    std::map<Key, std::unique_ptr<LatticeKernel>> steps_;
    std::map<Key, std::unique_ptr<LatticeKernel>> any_set_;  // tests at run time which rules act
    std::vector<std::string> notes_;
    std::string latest_note_;
    cl::Buffer parameters_;
    std::vector<KernelNumber> rule_parameters_;
    std::vector<std::uint32_t> parameter_words_;      // what the buffer holds
    mutable std::optional<LatticeNonFinite> finder_;  // made when first needed
};

}  // namespace

std::unique_ptr<Tissue> make_opencl_lattice(std::shared_ptr<const Session> session,
                                            std::shared_ptr<const Experiment> experiment, const Snapshot& initial,
                                            MakeStep make_step) {
    return std::make_unique<OpenclLattice>(std::move(session), std::move(experiment), initial, std::move(make_step));
}

}  // namespace pelage
