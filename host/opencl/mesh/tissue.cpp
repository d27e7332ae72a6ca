// See tissue.hpp.
#include "opencl/mesh/tissue.hpp"

#include "core/error.hpp"
#include "core/finite.hpp"
#include "core/schedule.hpp"
#include "core/space.hpp"
#include "opencl/device/cl_error.hpp"
#include "opencl/mesh/step.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>
#include <variant>

namespace pelage {

namespace {

std::shared_ptr<const MeshSurface> surface_of(const Experiment& experiment) {
    const Space space = space_of(experiment);
    const auto* mesh = std::get_if<MeshCells>(&space);
    if (mesh == nullptr) throw Error(experiment.source + ": the tissue is no mesh");
    return mesh->surface;
}

class OpenclMesh final : public Tissue {
public:
    OpenclMesh(std::shared_ptr<const Session> session, std::shared_ptr<const Experiment> shared,
               const Snapshot& initial)
        : Tissue(std::move(shared), initial),
          session_(std::move(session)),
          pace_(*session_),
          state_(*session_, experiment(), surface_of(experiment())) {
        take(initial);
    }

    std::optional<ProgramCounts> programs() const override { return session_->program_counts(); }

private:
    std::size_t do_cells() const override { return state_.cells(); }

    void do_advance(std::uint64_t first, std::uint64_t count) override {
        with_device(session_->info().name, [&] {
            upload_parameters(experiment().phase_at(first));
            const std::uint64_t end = first + count;
            for (std::uint64_t iteration = first; iteration < end;) {
                const std::uint64_t next = std::min(end, next_change(experiment(), iteration));
                step_for(iteration).enqueue(state_, parameters_, iteration, next - iteration, pace_);
                iteration = next;
            }
            session_->queue().flush();
        });
    }

    void do_set_rate(std::size_t chemical, double rate) override {
        with_device(session_->info().name, [&] { state_.fill_rate(chemical, rate); });
    }

    Snapshot do_read() const override {
        return with_device(session_->info().name, [&] { return state_.read(); });
    }

    void do_write(const Snapshot& snapshot) override {
        with_device(session_->info().name, [&] { take(snapshot); });
    }

    std::optional<NonFinite> do_non_finite() const override { return first_non_finite(do_read().conc); }

    void take(const Snapshot& snapshot) {
        if (snapshot.cells() != state_.cells() || snapshot.on_grid())
            throw Error(fmt::format("{}: the state has {} cells; the mesh has {} vertices", experiment().source,
                                    snapshot.cells(), state_.cells()));
        std::vector<RateKind> rates;
        for (std::size_t i = 0; i < experiment().chemicals.size(); ++i)
            rates.push_back(rate_kind(experiment(), snapshot.diff[i], i));
        if (rates != rates_) steps_.clear();
        rates_ = std::move(rates);
        state_.write(snapshot);
    }

    // Of the active rules alone, or once there are many such programs of all of them, tested as it runs.
    MeshStep& step_for(std::uint64_t iteration) {
        std::vector<bool> active = active_rules(experiment(), iteration);
        const bool full = steps_.size() >= session_->options().variants && !steps_.contains({active, false});
        if (full) active.assign(active.size(), true);
        std::unique_ptr<MeshStep>& step = steps_[{active, full}];
        if (!step) step = std::make_unique<MeshStep>(*session_, experiment(), rates_, active, full);
        return *step;
    }

    void upload_parameters(const Phase& phase) {
        if (uploaded_ == &phase) return;
        const Precision precision = session_->options().precision;
        const std::vector<std::uint32_t> words =
            parameter_words(mesh_parameters(experiment(), phase, precision), precision);
        const std::size_t bytes = words.size() * sizeof words[0];
        if (uploaded_ == nullptr) parameters_ = session_->buffer(bytes, "parameters");
        session_->queue().enqueueWriteBuffer(parameters_, CL_TRUE, 0, bytes, words.data());
        uploaded_ = &phase;
    }

    std::shared_ptr<const Session> session_;
    Pace pace_;
    MeshState state_;
    std::vector<RateKind> rates_;
    std::map<std::pair<std::vector<bool>, bool>, std::unique_ptr<MeshStep>> steps_;
    cl::Buffer parameters_;
    const Phase* uploaded_ = nullptr;  // whose numbers the buffer holds
};

}  // namespace

std::unique_ptr<Tissue> make_opencl_mesh(std::shared_ptr<const Session> session,
                                         std::shared_ptr<const Experiment> experiment, const Snapshot& initial) {
    const std::string device = session->info().name;
    return with_device(device, [&]() -> std::unique_ptr<Tissue> {
        return std::make_unique<OpenclMesh>(std::move(session), std::move(experiment), initial);
    });
}

}  // namespace pelage
