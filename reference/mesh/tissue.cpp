// One iteration of a mesh after another: rules, exchange along edges, what rules set, bounds.
#include "reference/mesh/tissue.hpp"

#include "core/error.hpp"
#include "core/fields.hpp"
#include "core/finite.hpp"
#include "core/rates.hpp"
#include "core/subnormal.hpp"
#include "core/surface.hpp"
#include "reference/neighbours/gather.hpp"
#include "reference/rules/rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <type_traits>
#include <utility>

namespace pelage {

namespace {

using namespace reference;

template <class T>
class MeshGround final : public Ground<T> {
public:
    MeshGround(const Experiment& experiment, const MeshSurface& surface) : adjacency_(surface.adjacency) {
        const Precision precision = std::is_same_v<T, float> ? Precision::single_ : Precision::double_;
        for (const std::vector<double>& values : mesh_blobs(experiment, surface, precision))
            this->fields.emplace_back(values.begin(), values.end());
        for (const double height : coordinates(surface, 2)) this->z.push_back(in_precision<T>(height));
    }

    std::vector<T> laplacian(const std::vector<T>& values) const override {
        std::vector<T> sums(values.size(), T(0));
        gather(adjacency_, Arithmetic::fused, std::vector<T>(values.size(), T(1)), T(1), values, sums);
        return sums;
    }

private:
    const Adjacency& adjacency_;
};

std::shared_ptr<const MeshSurface> surface_of(const Experiment& experiment, const Snapshot& state) {
    const Space space = space_of(experiment);
    const auto* mesh = std::get_if<MeshCells>(&space);
    if (mesh == nullptr) throw Error(experiment.source + ": the tissue is no mesh");
    if (state.cells() != mesh->surface->cells() || state.on_grid())
        throw Error(fmt::format("{}: the state has {} cells; the mesh has {} vertices", experiment.source,
                                state.cells(), mesh->surface->cells()));
    return mesh->surface;
}

template <class T>
class MeshTissue final : public Tissue {
public:
    MeshTissue(std::shared_ptr<const Experiment> shared, const Snapshot& initial)
        : Tissue(std::move(shared), initial),
          surface_(surface_of(experiment(), initial)),
          ground_(experiment(), *surface_) {
        do_write(initial);
    }

private:
    std::size_t do_cells() const override { return old_.cells(); }

    void do_advance(std::uint64_t first, std::uint64_t count) override {
        const SubnormalsAreZero scope(std::is_same_v<T, float>);
        for (std::uint64_t iteration = first; iteration < first + count; ++iteration) step(iteration);
    }

    void do_set_rate(std::size_t chemical, double rate) override {
        std::ranges::fill(old_.diff[chemical], in_precision<T>(rate));
    }

    Snapshot do_read() const override { return snapshot_from(old_); }

    void do_write(const Snapshot& snapshot) override {
        surface_of(experiment(), snapshot);
        old_ = state_from<T>(snapshot);
        diffuses_.clear();
        for (std::size_t i = 0; i < experiment().chemicals.size(); ++i)
            diffuses_.push_back(rate_kind(experiment(), snapshot.diff[i], i) != RateKind::none ? 1 : 0);
    }

    std::optional<NonFinite> do_non_finite() const override { return first_non_finite(old_.conc); }

    void step(std::uint64_t iteration) {
        const Phase& phase = experiment().phase_at(iteration);
        const T dt = in_precision<T>(phase.time_step);
        const Adjacency& adjacency = surface_->adjacency;
        next_ = old_;
        apply_rules(experiment(), iteration, Arithmetic::fused, ground_, old_, next_, requests_);
        for (std::size_t i = 0; i < next_.conc.size(); ++i) {
            if (diffuses_[i] != 0) gather(adjacency, Arithmetic::fused, old_.diff[i], dt, old_.conc[i], next_.conc[i]);
            replace_and_bound(i, phase.bounds[i]);
        }
        for (std::size_t cell = 0; cell < next_.neighbours.size(); ++cell)
            next_.neighbours[cell] = static_cast<std::int32_t>(adjacency.count(cell));
        std::swap(old_, next_);
    }

    void replace_and_bound(std::size_t chemical, const Bounds& bounds) {
        std::vector<T>& values = next_.conc[chemical];
        const Remembered<T>& set = requests_.set_conc[chemical];
        for (std::size_t cell = 0; cell < set.present.size(); ++cell) {
            if (set.present[cell] != 0) values[cell] = set.value[cell];
        }
        const T floor = in_precision<T>(bounds.floor);
        const T limit = in_precision<T>(bounds.limit);
        for (T& value : values) value = value < floor ? floor : value > limit ? limit : value;
    }

    std::shared_ptr<const MeshSurface> surface_;
    MeshGround<T> ground_;
    std::vector<std::uint8_t> diffuses_;  // [chemical]; 0: its rate is 0 in every cell and for good
    State<T> old_, next_;
    Requests<T> requests_;
};

}  // namespace

std::unique_ptr<Tissue> make_reference_mesh(std::shared_ptr<const Experiment> experiment, const Snapshot& initial,
                                            Precision precision) {
    if (precision == Precision::single_) return std::make_unique<MeshTissue<float>>(std::move(experiment), initial);
    return std::make_unique<MeshTissue<double>>(std::move(experiment), initial);
}

}  // namespace pelage
