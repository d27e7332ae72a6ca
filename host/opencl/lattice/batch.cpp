// See batch.hpp.
#include "opencl/lattice/batch.hpp"

#include "core/error.hpp"
#include "core/events.hpp"
#include "core/schedule.hpp"
#include "opencl/device/cl_error.hpp"
#include "opencl/device/pace.hpp"
#include "opencl/lattice/choice.hpp"
#include "opencl/lattice/emit_batch.hpp"
#include "opencl/lattice/phase_numbers.hpp"
#include "opencl/lattice/state.hpp"
#include "opencl/lattice/step.hpp"
#include "opencl/lattice/structure.hpp"
#include "opencl/lattice/tile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

namespace pelage {

namespace {

class OpenclBatch final : public Batch {
public:
    OpenclBatch(std::shared_ptr<const Session> session, const std::vector<BatchStart>& starts)
        : session_(std::move(session)),
          pace_(*session_),
          plan_(lattice_plan(*starts.front().experiment, starts.front().state)),
          every_(starts.front().experiment->rules.size(), true),
          every_use_(emit_rules(*starts.front().experiment, every_, session_->options().precision).use),
          iteration_(starts.front().state.iteration) {
        std::vector<LatticeStart> of_members;
        for (const BatchStart& start : starts) {
            members_.push_back({start.experiment, rule_parameters(*start.experiment, session_->options().precision)});
            of_members.push_back({*start.experiment, start.state});
        }
        with_device(session_->info().name,
                    [&] { state_ = std::make_unique<LatticeState>(*session_, of_members, plan_, every_use_); });
    }

    std::uint64_t iteration() const override { return iteration_; }
    std::vector<std::string> report() const override { return notes_; }

    void advance(std::uint64_t iterations) override {
        if (lost_) throw Error("the batch's states are lost, for an earlier call failed half-way");
        lost_ = true;
        const std::uint64_t end = iteration_ + iterations;
        with_device(session_->info().name, [&] {
            while (iteration_ < end && state_->running() > 0) {
                begin_phases();
                const std::uint64_t next = std::min(end, next_event(first(), iteration_));
                upload_parameters();
                carry_out(next);
            }
            session_->queue().flush();
        });
        iteration_ = end;
        lost_ = false;
    }

    Snapshot read(std::size_t member) const override {
        if (lost_) throw Error("the batch's states are lost, for an earlier call failed half-way");
        Snapshot snapshot = with_device(session_->info().name, [&] { return state_->read(member); });
        snapshot.iteration = iteration_;
        return snapshot;
    }

    void end(std::size_t member) override { state_->end(member); }

private:
    struct Member {
        std::shared_ptr<const Experiment> experiment;
        std::vector<KernelNumber> rule_numbers;
    };

    // What acts when is the same for all of them.
    const Experiment& first() const { return *members_.front().experiment; }

    void begin_phases() {
        for (std::size_t member = 0; member < members_.size(); ++member) {
            const Phase& phase = members_[member].experiment->phase_at(iteration_);
            if (phase.begin != iteration_) return;
            for (std::size_t chemical = 0; chemical < phase.rates.size(); ++chemical) {
                if (phase.rates[chemical]) state_->set_rate(chemical, *phase.rates[chemical], member);
            }
        }
    }

    void carry_out(std::uint64_t end) {
        while (iteration_ < end) {
            const std::uint64_t next = std::min(end, next_change(first(), iteration_));
            LatticeKernel& step = step_for(active_rules(first(), iteration_));
            if (!counted_) {  // rules may read the counts: they change after this one iteration
                step.enqueue(*state_, parameters_, iteration_++, 1, pace_);
                state_->counted();
                counted_ = true;
            }
            step.enqueue(*state_, parameters_, iteration_, next - iteration_, pace_);
            iteration_ = next;
        }
    }

    LatticeKernel& step_for(const std::vector<bool>& active) {
        std::unique_ptr<LatticeKernel>& known = steps_[active];
        if (known) return *known;
        steps_.erase(active);
        if (steps_.size() >= session_->options().variants) {
            if (!any_set_) any_set_ = make_step(every_, true);
            return *any_set_;
        }
        return *(steps_[active] = make_step(active, false));
    }

    std::unique_ptr<LatticeKernel> make_step(const std::vector<bool>& active, bool test_intervals) {
        const RuleUse use =
            test_intervals ? every_use_ : emit_rules(first(), active, session_->options().precision).use;
        Work work;
        work.cells = static_cast<double>(state_->grid().cells() * state_->running());
        const Choice choice =
            choose_for_batch(session_->info(), rule_needs(first(), plan_, use), work, session_->options());
        const std::string note = fmt::format("{} lattices {}", members_.size(), choice.text());
        if (notes_.empty() || notes_.back() != note) notes_.push_back(note);
        if (choice.path == Path::tiled)
            return std::make_unique<TiledStep>(*session_, first(), plan_, active, test_intervals, choice);
        return std::make_unique<LatticeStep>(*session_, first(), plan_, active, test_intervals, choice, nullptr);
    }

    // A row of numbers for each, as emit_batch.hpp says.
    std::vector<std::uint32_t> table() const {
        const Precision precision = session_->options().precision;
        std::vector<std::uint32_t> words;
        for (std::size_t member = 0; member < members_.size(); ++member) {
            const auto& [experiment, rules] = members_[member];
            std::vector<KernelNumber> values = phase_numbers(*experiment, plan_, state_->uniform_rates(member),
                                                             experiment->phase_at(iteration_), precision);
            values.insert(values.end(), rules.begin(), rules.end());
            const auto seed = static_cast<std::uint64_t>(experiment->run_seed());
            values.resize(batch_stride(values.size()), 0.0);
            values[values.size() - 2] = static_cast<std::uint32_t>(seed & 0xffffffffu);
            values.back() = static_cast<std::uint32_t>(seed >> 32);
            const std::vector<std::uint32_t> row = parameter_words(values, precision);
            words.insert(words.end(), row.begin(), row.end());
        }
        return words;
    }

    void upload_parameters() {
        std::vector<std::uint32_t> words = table();
        if (words == parameter_words_) return;
        if (parameters_() == nullptr) parameters_ = session_->buffer(words.size() * sizeof words[0], "parameters");
        session_->queue().enqueueWriteBuffer(parameters_, CL_TRUE, 0, words.size() * sizeof words[0], words.data());
        parameter_words_ = std::move(words);
    }

    std::shared_ptr<const Session> session_;
    Pace pace_;
    std::vector<Member> members_;
    LatticePlan plan_;
    std::vector<bool> every_;
    RuleUse every_use_;
    std::unique_ptr<LatticeState> state_;
    std::uint64_t iteration_;
    bool counted_ = false;
    bool lost_ = false;
    std::map<std::vector<bool>, std::unique_ptr<LatticeKernel>> steps_;
    std::unique_ptr<LatticeKernel> any_set_;  // tests at run time which rules act
    std::vector<std::string> notes_;
    cl::Buffer parameters_;
    std::vector<std::uint32_t> parameter_words_;  // what the buffer holds
};

}  // namespace

std::unique_ptr<Batch> make_opencl_batch(std::shared_ptr<const Session> session,
                                         const std::vector<BatchStart>& starts) {
    if (starts.empty()) throw Error("a batch has at least one lattice; found none");
    const Precision precision = session->options().precision;
    const std::string structure = structure_of(*starts.front().experiment, starts.front().state, precision);
    if (structure.empty())
        throw Error(fmt::format("{}: a batch is of lattices that do not grow", starts.front().experiment->source));
    for (const BatchStart& start : starts) {
        if (structure_of(*start.experiment, start.state, precision) == structure) continue;
        throw Error(fmt::format("{}: the lattices of a batch differ in numbers, seed and state alone",
                                start.experiment->source));
    }
    return std::make_unique<OpenclBatch>(std::move(session), starts);
}

}  // namespace pelage
