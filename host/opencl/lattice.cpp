// See lattice.hpp.
#include "opencl/lattice.hpp"

#include "core/schedule.hpp"
#include "opencl/cl_error.hpp"
#include "opencl/emit_lattice.hpp"
#include "opencl/lattice_state.hpp"
#include "opencl/lattice_step.hpp"
#include "opencl/program.hpp"
#include "opencl/stream_step.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <variant>

namespace pelage {

namespace {

template <class T>
void put_parameters(std::vector<double>& values, const Experiment& experiment, const LatticePlan& plan,
                    const LatticeState& state, const Phase& phase) {
    const T dt = static_cast<T>(phase.time_step);
    values[0] = double{dt};
    for (std::size_t i = 0; i < experiment.chemicals.size(); ++i) {
        const auto put = [&](LatticeParameter what, T value) { values[parameter_place(i, what)] = double{value}; };
        const T rate = static_cast<T>(state.uniform_rate(i));
        put(LatticeParameter::floor, static_cast<T>(phase.bounds[i].floor));
        put(LatticeParameter::limit, static_cast<T>(phase.bounds[i].limit));
        put(LatticeParameter::rate, rate);
        put(LatticeParameter::share, (rate * dt) / static_cast<T>(stencil_divisor(plan.stencil)));
    }
}

class OpenclLattice final : public Tissue {
public:
    OpenclLattice(std::shared_ptr<const Session> session, std::shared_ptr<const Experiment> experiment,
                  const Snapshot& initial)
        : Tissue(std::move(experiment), initial), session_(std::move(session)), pace_(*session_) {
        do_write(initial);
    }

private:
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
        with_device(session_->info().name, [&] { state_->expand(insertion); });
        counted_ = false;
    }

    void do_set_rate(std::size_t chemical, double rate) override {
        with_device(session_->info().name, [&] { state_->set_rate(chemical, rate); });
    }

    Snapshot do_read() const override {
        return with_device(session_->info().name, [&] { return state_->read(); });
    }

    void do_write(const Snapshot& snapshot) override {
        with_device(session_->info().name, [&] {
            const LatticePlan plan = lattice_plan(experiment(), snapshot);
            const std::vector<bool> every(experiment().rules.size(), true);
            const RuleUse use = emit_rules(experiment(), every, session_->options().precision).use;
            state_ = std::make_unique<LatticeState>(*session_, experiment(), plan, use, snapshot);
            if (plan.rates != plan_.rates || plan.polarity != plan_.polarity) {  // all else is the experiment's
                steps_.clear();
                any_set_ = {};
            }
            plan_ = plan;
            counted_ = false;
        });
    }

    std::optional<NonFinite> do_non_finite() const override {
        return with_device(session_->info().name, [&] { return find_non_finite(); });
    }

    // The kernel for `count` iterations from `iteration` on.
    LatticeKernel& step_for(std::uint64_t iteration, std::uint64_t count) {
        std::vector<bool> active = active_rules(experiment(), iteration);
        for (std::size_t i = 0; i < active.size(); ++i) {
            if (std::holds_alternative<Expand>(experiment().rules[i].action)) active[i] = false;
        }
        const bool fused = wants_fusion(work_[active] += static_cast<double>(count) * static_cast<double>(do_cells()));
        if (steps_.size() >= session_->options().variants && !steps_.contains({active, fused})) {
            std::unique_ptr<LatticeKernel>& step = any_set_[fused ? 1 : 0];
            if (!step) step = make_step(std::vector<bool>(active.size(), true), true, fused);
            return *step;
        }
        std::unique_ptr<LatticeKernel>& step = steps_[{active, fused}];
        if (!step) step = make_step(active, false, fused);
        return *step;
    }

    // A fused program takes seconds to compile: that much `work`, in cell-updates, must have come by.
    bool wants_fusion(double work) const {
        const Fusion fusion = session_->options().fusion;
        return fusion == Fusion::automatic ? is_cpu(*session_) && work >= 5e7 : fusion == Fusion::always;
    }

    std::unique_ptr<LatticeKernel> make_step(const std::vector<bool>& active, bool test_intervals, bool fused) const {
        const RuleUse use = emit_rules(experiment(), active, session_->options().precision, test_intervals).use;
        if (fused && why_not_fused(plan_, use).empty()) {
            return std::make_unique<StreamStep>(*session_, experiment(), plan_, active, test_intervals);
        }
        return std::make_unique<LatticeStep>(*session_, experiment(), plan_, active, test_intervals);
    }

    void upload_parameters(const Phase& phase) {
        std::vector<double> values(parameter_place(experiment().chemicals.size(), LatticeParameter::floor));
        if (session_->is_double()) {
            put_parameters<double>(values, experiment(), plan_, *state_, phase);
        } else {
            put_parameters<float>(values, experiment(), plan_, *state_, phase);
        }
        if (values == parameter_values_) return;
        if (parameters_() == nullptr)
            parameters_ = session_->buffer(values.size() * session_->scalar_bytes(), "parameters");
        if (session_->is_double()) {
            session_->queue().enqueueWriteBuffer(parameters_, CL_TRUE, 0, values.size() * 8, values.data());
        } else {
            const std::vector<float> rounded(values.begin(), values.end());
            session_->queue().enqueueWriteBuffer(parameters_, CL_TRUE, 0, rounded.size() * 4, rounded.data());
        }
        parameter_values_ = values;
    }

    std::optional<NonFinite> find_non_finite() const {
        const Grid& grid = state_->grid();
        std::vector<cl_uint> found(experiment().chemicals.size(), 0xffffffffu);
        if (finder_() == nullptr) {
            Source source;
            source.file("prelude.cl").file("non_finite.cl");
            finder_ = cl::Kernel(session_->build(source.str()), "pelage_lattice_non_finite");
            found_ = session_->buffer(found.size() * 4, "search results");
        }
        const cl::CommandQueue& queue = session_->queue();
        queue.enqueueWriteBuffer(found_, CL_TRUE, 0, found.size() * 4, found.data());
        finder_.setArg(0, state_->conc().now());
        finder_.setArg(1, found_);
        finder_.setArg(2, static_cast<cl_int>(grid.columns));
        finder_.setArg(3, static_cast<cl_int>(grid.rows));
        finder_.setArg(4, static_cast<cl_int>(grid.pitch()));
        finder_.setArg(5, static_cast<cl_int>(found.size()));
        const std::size_t items = std::min<std::size_t>(grid.rows, 8 * session_->info().compute_units);
        queue.enqueueNDRangeKernel(finder_, cl::NullRange, cl::NDRange(items), cl::NDRange(1));
        queue.enqueueReadBuffer(found_, CL_TRUE, 0, found.size() * 4, found.data());
        for (std::size_t chemical = 0; chemical < found.size(); ++chemical) {
            if (found[chemical] != 0xffffffffu) return NonFinite{chemical, found[chemical]};
        }
        return std::nullopt;
    }

    std::shared_ptr<const Session> session_;
    Pace pace_;
    LatticePlan plan_;
    std::unique_ptr<LatticeState> state_;
    bool counted_ = false;                      // state_ has been told that an iteration has been carried out
    std::map<std::vector<bool>, double> work_;  // cell-updates asked for, by active rules
    // By active rules and whether fused; any_set_ tests at run time which rules act, [1] fused.
    std::map<std::pair<std::vector<bool>, bool>, std::unique_ptr<LatticeKernel>> steps_;
    std::array<std::unique_ptr<LatticeKernel>, 2> any_set_;
    cl::Buffer parameters_;
    std::vector<double> parameter_values_;
    mutable cl::Kernel finder_;
    mutable cl::Buffer found_;
};

}  // namespace

std::unique_ptr<Tissue> make_opencl_lattice(std::shared_ptr<const Session> session,
                                            std::shared_ptr<const Experiment> experiment, const Snapshot& initial) {
    return std::make_unique<OpenclLattice>(std::move(session), std::move(experiment), initial);
}

}  // namespace pelage
