// See backend.hpp.
#include "opencl/backend.hpp"

#include "core/space.hpp"
#include "core/visit.hpp"
#include "opencl/cells/tissue.hpp"
#include "opencl/device/cl_error.hpp"
#include "opencl/device/session.hpp"
#include "opencl/lattice/batch.hpp"
#include "opencl/lattice/structure.hpp"
#include "opencl/tissue.hpp"

#include <fmt/format.h>

namespace pelage {

namespace {

class DeviceBackend final : public OpenclBackend {
public:
    explicit DeviceBackend(const OpenclOptions& options)
        : session_(std::make_shared<Session>(select_device(options.device), options)) {}

    std::string name() const override { return "opencl: " + session_->info().name; }
    Precision precision() const override { return session_->options().precision; }
    const DeviceInfo& device() const override { return session_->info(); }
    std::string build_options() const override { return session_->build_options(); }

    std::string why_not(const Experiment& experiment) const override {
        if (session_->is_double() && !session_->info().fp64) {
            return fmt::format("device '{}' has no double precision", session_->info().name);
        }
        return std::visit(
            Overloaded{[](const Lattice&) { return std::string(); }, [](const Volume&) { return std::string(); },
                       [](const MeshCells&) { return std::string(); },
                       [&](const FreeCells&) { return why_not_cells(experiment); }},
            space_of(experiment));
    }

    using Backend::make_tissue;
    std::unique_ptr<Tissue> make_tissue(const Experiment& experiment, const Snapshot& initial) override {
        validate(experiment);
        const std::string reason = why_not(experiment);
        if (!reason.empty()) throw Error(experiment.source + ": " + reason);
        return make_opencl_tissue(session_, std::make_shared<const Experiment>(experiment), initial);
    }

    std::string structure(const Experiment& experiment, const Snapshot& initial) const override {
        return why_not(experiment).empty() ? structure_of(experiment, initial, precision()) : "";
    }

    std::size_t batch_room(const Experiment& experiment, const Snapshot& initial) const override {
        return pelage::batch_room(session_->info(), experiment, initial, precision());
    }

    std::unique_ptr<Batch> make_batch(const std::vector<BatchStart>& starts) override {
        for (const BatchStart& start : starts) {
            validate(*start.experiment);
            const std::string reason = why_not(*start.experiment);
            if (!reason.empty()) throw Error(start.experiment->source + ": " + reason);
        }
        return make_opencl_batch(session_, starts);
    }

private:
    std::shared_ptr<const Session> session_;
};

}  // namespace

std::unique_ptr<OpenclBackend> opencl_backend(const OpenclOptions& options) {
    return std::make_unique<DeviceBackend>(options);
}

}  // namespace pelage
