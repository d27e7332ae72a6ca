// See backend.hpp.
#include "opencl/backend.hpp"

#include "core/prepattern.hpp"
#include "opencl/cells.hpp"
#include "opencl/cl_error.hpp"
#include "opencl/lattice.hpp"
#include "opencl/session.hpp"

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
        return is_lattice(experiment) ? "" : why_not_cells(experiment);
    }

    using Backend::make_tissue;
    std::unique_ptr<Tissue> make_tissue(const Experiment& experiment, const Snapshot& initial) override {
        validate(experiment);
        const std::string reason = why_not(experiment);
        if (!reason.empty()) throw Error(experiment.source + ": " + reason);
        auto shared = std::make_shared<const Experiment>(experiment);
        if (is_lattice(experiment)) return make_opencl_lattice(session_, std::move(shared), initial);
        CellsOptions options;
        options.search = session_->options().neighbours;
        options.sorting = session_->options().sorting;
        return make_opencl_cells(session_, std::move(shared), initial, options);
    }

private:
    std::shared_ptr<const Session> session_;
};

}  // namespace

std::unique_ptr<OpenclBackend> opencl_backend(const OpenclOptions& options) {
    return std::make_unique<DeviceBackend>(options);
}

}  // namespace pelage
