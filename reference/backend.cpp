// See backend.hpp.
#include "reference/backend.hpp"

#include "core/error.hpp"
#include "core/prepattern.hpp"
#include "reference/cells.hpp"
#include "reference/lattice.hpp"

namespace pelage {

namespace {

class ReferenceBackend final : public Backend {
public:
    explicit ReferenceBackend(Precision precision) : precision_(precision) {}

    std::string name() const override { return "reference"; }
    Precision precision() const override { return precision_; }
    std::string why_not(const Experiment&) const override { return {}; }

    std::unique_ptr<Tissue> make_tissue(const Experiment& experiment, const Snapshot& initial) override {
        validate(experiment);
        auto shared = std::make_shared<const Experiment>(experiment);
        if (is_lattice(experiment)) return make_reference_lattice(std::move(shared), initial, precision_);
        return make_reference_cells(std::move(shared), initial, precision_);
    }
    using Backend::make_tissue;

private:
    Precision precision_;
};

}  // namespace

std::unique_ptr<Backend> reference_backend(Precision precision) {
    return std::make_unique<ReferenceBackend>(precision);
}

}  // namespace pelage
