// See backend.hpp.
#include "reference/backend.hpp"

#include "core/error.hpp"
#include "core/space.hpp"
#include "core/visit.hpp"
#include "reference/aggregate/tissue.hpp"
#include "reference/cells/tissue.hpp"
#include "reference/lattice/tissue.hpp"
#include "reference/mesh/tissue.hpp"

namespace pelage {

namespace {

class ReferenceBackend final : public Backend {
public:
    ReferenceBackend(Precision precision, NeighbourSearch search, SpatialSorting sorting)
        : precision_(precision), search_(search), sorting_(sorting) {}

    std::string name() const override { return "reference"; }
    Precision precision() const override { return precision_; }
    std::string why_not(const Experiment&) const override { return {}; }

    std::unique_ptr<Tissue> make_tissue(const Experiment& experiment, const Snapshot& initial) override {
        validate(experiment);
        auto shared = std::make_shared<const Experiment>(experiment);
        return std::visit(Overloaded{[&](const Lattice& lattice) {
                                         return lattice.charges ? make_reference_aggregate(shared, initial)
                                                                : make_reference_lattice(shared, initial, precision_);
                                     },
                                     [&](const Volume&) { return make_reference_lattice(shared, initial, precision_); },
                                     [&](const MeshCells&) { return make_reference_mesh(shared, initial, precision_); },
                                     [&](const FreeCells&) {
                                         return make_reference_cells(shared, initial, precision_, search_, sorting_);
                                     }},
                          space_of(experiment));
    }
    using Backend::make_tissue;

private:
    Precision precision_;
    NeighbourSearch search_;
    SpatialSorting sorting_;
};

}  // namespace

std::unique_ptr<Backend> reference_backend(Precision precision, NeighbourSearch search, SpatialSorting sorting) {
    return std::make_unique<ReferenceBackend>(precision, search, sorting);
}

}  // namespace pelage
