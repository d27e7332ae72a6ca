// See tissue_tasks.hpp.
#include "bench/tissue_tasks.hpp"

#include "opencl/device/cl_error.hpp"
#include "opencl/tissue.hpp"
#include "reference/backend.hpp"

#include <algorithm>

namespace pelage::bench {

namespace {

std::unique_ptr<Tissue> on_device(std::shared_ptr<const Session> session, const Experiment& experiment,
                                  const Snapshot& initial) {
    return make_opencl_tissue(std::move(session), std::make_shared<const Experiment>(experiment), initial);
}

class TissueTask final : public Task {
public:
    TissueTask(std::unique_ptr<Tissue> tissue, std::shared_ptr<const Snapshot> initial,
               std::shared_ptr<const Session> session)
        : session_(std::move(session)), initial_(std::move(initial)), tissue_(std::move(tissue)) {}

    void work(std::uint64_t iterations) override {
        tissue_->advance(iterations);
        finish();
    }

    void restart() override {
        tissue_->write(*initial_);
        finish();
    }

    Outcome outcome() const override { return outcome_of(tissue_->read()); }

private:
    void finish() {
        if (!session_) return;
        with_device(session_->info().name, [&] { session_->queue().finish(); });
    }

    std::shared_ptr<const Session> session_;  // none: the reference, which never works behind one's back
    std::shared_ptr<const Snapshot> initial_;
    std::unique_ptr<Tissue> tissue_;
};

}  // namespace

Outcome outcome_of(const Snapshot& state) {
    Outcome found;
    if (!state.on_grid()) {
        found.push_back(float_array("x", state.x));
        found.push_back(float_array("y", state.y));
    }
    for (std::size_t i = 0; i < state.conc.size(); ++i) {
        found.push_back(float_array("chemical " + std::to_string(i), state.conc[i]));
    }
    return found;
}

std::unique_ptr<Task> reference_task(const Experiment& experiment, std::shared_ptr<const Snapshot> initial) {
    auto tissue = reference_backend(Precision::single_)->make_tissue(experiment, *initial);
    return std::make_unique<TissueTask>(std::move(tissue), std::move(initial), nullptr);
}

std::unique_ptr<Task> opencl_task(std::shared_ptr<const Session> session, const Experiment& experiment,
                                  std::shared_ptr<const Snapshot> initial) {
    auto tissue = on_device(session, experiment, *initial);
    return std::make_unique<TissueTask>(std::move(tissue), std::move(initial), std::move(session));
}

double count_updates(std::shared_ptr<const Session> session, const Experiment& experiment, const Snapshot& initial,
                     std::uint64_t iterations) {
    const auto tissue = on_device(std::move(session), experiment, initial);
    const std::uint64_t stride = std::max<std::uint64_t>(1, iterations / 64);
    double updates = 0;
    while (tissue->iteration() < iterations) {
        const std::uint64_t count = std::min(stride, iterations - tissue->iteration());
        const auto before = static_cast<double>(tissue->cells());
        tissue->advance(count);
        updates += static_cast<double>(count) * (before + static_cast<double>(tissue->cells())) / 2;
    }
    return updates;
}

}  // namespace pelage::bench
