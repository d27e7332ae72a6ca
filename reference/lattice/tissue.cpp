// One iteration of a lattice or a volume after another: rules, diffusion, what rules set, bounds, polarity.
#include "reference/lattice/tissue.hpp"

#include "core/fields.hpp"
#include "core/finite.hpp"
#include "core/growable.hpp"
#include "core/lattice.hpp"
#include "core/subnormal.hpp"
#include "reference/lattice/exchange.hpp"
#include "reference/lattice/expansion.hpp"
#include "reference/lattice/resample.hpp"
#include "reference/rules/rules.hpp"

#include <algorithm>
#include <type_traits>
#include <utility>

namespace pelage {

namespace {

using namespace reference;

template <class T>
class LatticeGround final : public Ground<T> {
public:
    explicit LatticeGround(const Medium& medium) : medium_(medium) {}

    std::vector<T> laplacian(const std::vector<T>& values) const override { return laplacian_of(medium_, values); }
    std::vector<T> gradient(const std::vector<T>& values, Axis axis) const override {
        return gradient_of(medium_, axis, values);
    }
    std::vector<T> stencil(const NamedStencil& stencil, const std::vector<T>& values) const override {
        return stencil_of(medium_, stencil, values);
    }

private:
    const Medium& medium_;
};

template <class T>
class LatticeTissue final : public Growable {
public:
    LatticeTissue(std::shared_ptr<const Experiment> experiment, const Snapshot& initial)
        : Growable(std::move(experiment), initial) {
        do_write(initial);
    }

private:
    std::size_t do_cells() const override { return state_.cells(); }

    void do_advance(std::uint64_t first, std::uint64_t count) override {
        const SubnormalsAreZero scope(std::is_same_v<T, float>);
        for (std::uint64_t iteration = first; iteration < first + count; ++iteration) step(iteration);
    }

    void do_expand(const Insertion& insertion) override {
        expand_state(state_, insertion, iteration());
        reshape();
    }

    void do_resample(const Resampling& resampling) override {
        const SubnormalsAreZero scope(std::is_same_v<T, float>);
        resample_state(state_, resampling, experiment().phase_at(iteration()).bounds);
        reshape();
    }

    void do_set_rate(std::size_t chemical, double rate) override {
        for (T& value : state_.diff[chemical]) value = in_precision<T>(rate);
    }

    Snapshot do_read() const override { return snapshot_from(state_); }

    void do_read_conc(std::size_t chemical, std::vector<float>& to) const override {
        to.resize(state_.cells());
        std::ranges::transform(state_.conc[chemical], to.begin(), [](T value) { return static_cast<float>(value); });
    }

    void do_write(const Snapshot& snapshot) override {
        plan_ = lattice_plan(experiment(), snapshot);
        state_ = state_from<T>(snapshot);
        reshape();
    }

    std::optional<NonFinite> do_non_finite() const override { return first_non_finite(state_.conc); }

    void reshape() {
        medium_.lattice = plan_;
        medium_.lattice.columns = state_.columns;
        medium_.lattice.rows = state_.rows;
        if (plan_.volume()) {
            medium_.volume = plan_.as_volume();
            medium_.adjacency = volume_adjacency(*medium_.volume);
        } else {
            medium_.adjacency = lattice_adjacency(medium_.lattice);
        }
        constexpr Precision precision = std::is_same_v<T, float> ? Precision::single_ : Precision::double_;
        const Extent extent{state_.columns, state_.rows, state_.origin_x, state_.origin_y, state_.layers};
        ground_.fields.clear();
        for (const std::vector<double>& values : field_values(experiment(), extent, precision))
            ground_.fields.emplace_back(values.begin(), values.end());
        counts_.resize(state_.cells());
        for (std::size_t cell = 0; cell < counts_.size(); ++cell) {
            counts_[cell] = static_cast<std::int32_t>(medium_.adjacency.count(cell));
        }
    }

    // Everything is read from state_ and written to next_, which begins as its copy.
    void step(std::uint64_t iteration) {
        const Phase& phase = experiment().phase_at(iteration);
        next_ = state_;
        apply_rules(experiment(), iteration, plan_.arithmetic, ground_, state_, next_, requests_);
        for (std::size_t chemical = 0; chemical < next_.conc.size(); ++chemical) {
            diffuse(chemical, in_precision<T>(phase.time_step));
            replace(requests_.set_conc[chemical], next_.conc[chemical]);
            clamp(phase.bounds[chemical], next_.conc[chemical]);
        }
        follow_gradients(medium_, requests_.polarize, state_, next_);
        next_.neighbours = counts_;
        std::swap(state_, next_);
    }

    void diffuse(std::size_t chemical, T dt) {
        switch (plan_.rates[chemical]) {
            case RateKind::none:
                break;
            case RateKind::uniform:
                diffuse_uniform(medium_, chemical, dt, state_, next_);
                break;
            case RateKind::per_cell: {
                const bool anisotropic = experiment().chemicals[chemical].anisotropic;
                diffuse_per_cell(medium_, chemical, anisotropic, dt, state_, next_);
                break;
            }
        }
    }

    static void replace(const Remembered<T>& set, std::vector<T>& values) {
        for (std::size_t cell = 0; cell < set.present.size(); ++cell) {
            if (set.present[cell] != 0) values[cell] = set.value[cell];
        }
    }

    static void clamp(const Bounds& bounds, std::vector<T>& values) {
        const T floor = in_precision<T>(bounds.floor);
        const T limit = in_precision<T>(bounds.limit);
        for (T& value : values) value = value < floor ? floor : value > limit ? limit : value;
    }

    LatticePlan plan_;
    Medium medium_;
    LatticeGround<T> ground_{medium_};
    std::vector<std::int32_t> counts_;  // neighbours of each cell
    State<T> state_;
    State<T> next_;
    Requests<T> requests_;
};

}  // namespace

std::unique_ptr<Tissue> make_reference_lattice(std::shared_ptr<const Experiment> experiment, const Snapshot& initial,
                                               Precision precision) {
    if (precision == Precision::single_) return std::make_unique<LatticeTissue<float>>(std::move(experiment), initial);
    return std::make_unique<LatticeTissue<double>>(std::move(experiment), initial);
}

}  // namespace pelage
