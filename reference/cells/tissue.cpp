// See tissue.hpp.
#include "reference/cells/tissue.hpp"

#include "core/error.hpp"
#include "core/finite.hpp"
#include "core/rates.hpp"
#include "core/searching.hpp"
#include "core/subnormal.hpp"
#include "reference/cells/divide.hpp"
#include "reference/cells/interaction.hpp"
#include "reference/neighbours/neighbours.hpp"
#include "reference/neighbours/spatial_sorting.hpp"
#include "reference/rules/rules.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace pelage {

namespace reference {

namespace {

template <class T>
T clamped(T value, T low, T high) {
    return value < low ? low : value > high ? high : value;
}

template <class T>
class Cells final : public Tissue, public Searching {
public:
    Cells(std::shared_ptr<const Experiment> shared, const Snapshot& initial, NeighbourSearch search,
          SpatialSorting sorting)
        : Tissue(std::move(shared), initial),
          search_(search),
          lists_(static_cast<T>(interaction_range)),
          matrix_(sorting) {
        if (initial.lattice()) throw Error("a lattice has no free cells; it is stepped by the lattice reference");
        take(initial);
    }

    std::optional<SearchStatistics> search_statistics() const override {
        if (search_ != NeighbourSearch::spatial_sorting) return std::nullopt;
        return matrix_.statistics();
    }

private:
    std::size_t do_cells() const override { return old_.cells(); }
    void do_advance(std::uint64_t first, std::uint64_t count) override {
        const SubnormalsAreZero scope(std::is_same_v<T, float>);
        for (std::uint64_t i = 0; i < count; ++i) step(first + i);
    }
    void do_set_rate(std::size_t chemical, double rate) override {
        std::ranges::fill(old_.diff[chemical], in_precision<T>(rate));
    }
    Snapshot do_read() const override {
        Snapshot snapshot = snapshot_from(old_);
        if (search_ == NeighbourSearch::spatial_sorting) snapshot.order = matrix_.order();
        return snapshot;
    }
    void do_write(const Snapshot& snapshot) override { take(snapshot); }
    std::optional<NonFinite> do_non_finite() const override { return first_non_finite(old_.conc); }

    void take(const Snapshot&);
    void step(std::uint64_t iteration);
    const Neighbours& find_neighbours();
    void replace_and_bound(const Phase&);
    void confine(std::size_t cells);
    void average_mirrors();

    NeighbourSearch search_;
    NeighbourLists<T> lists_;
    SortedMatrix<T> matrix_;
    Neighbours found_;  // by spatial sorting
    Interaction<T> interaction_;
    State<T> old_, next_;
    Requests<T> requests_;
};

template <class T>
void Cells<T>::take(const Snapshot& snapshot) {
    old_ = state_from<T>(snapshot);
    lists_.forget();
    matrix_.begin(search_ == NeighbourSearch::spatial_sorting ? snapshot.order : std::vector<std::uint32_t>{});
    interaction_.exact = search_ != NeighbourSearch::spatial_sorting;
    interaction_.diffuses.clear();
    interaction_.anisotropic.clear();
    for (std::size_t chemical = 0; chemical < experiment().chemicals.size(); ++chemical) {
        interaction_.diffuses.push_back(
            rate_kind(experiment(), snapshot.diff[chemical], chemical) != RateKind::none ? 1 : 0);
        interaction_.anisotropic.push_back(experiment().chemicals[chemical].anisotropic ? 1 : 0);
    }
}

template <class T>
void Cells<T>::step(std::uint64_t iteration) {
    const Phase& phase = experiment().phase_at(iteration);
    const std::size_t cells = old_.cells();
    interaction_.dt = in_precision<T>(phase.time_step);
    next_ = old_;
    apply_rules(experiment(), iteration, Arithmetic::published, Ground<T>(), old_, next_, requests_);
    interact(interaction_, find_neighbours(), requests_.polarize, old_, next_);
    replace_and_bound(phase);
    confine(cells);
    average_mirrors();
    judge_divisions(requests_.divisions, old_, experiment().division_limit);
    append_children(requests_.divisions, iteration, old_, next_);
    std::swap(old_, next_);
}

template <class T>
const Neighbours& Cells<T>::find_neighbours() {
    if (search_ != NeighbourSearch::spatial_sorting) {
        lists_.update(old_.x, old_.y);
        return lists_.candidates();
    }
    matrix_.update(old_.x, old_.y);
    found_ = matrix_.neighbours();
    return found_;
}

template <class T>
void Cells<T>::replace_and_bound(const Phase& phase) {
    for (std::size_t chemical = 0; chemical < next_.conc.size(); ++chemical) {
        std::vector<T>& conc = next_.conc[chemical];
        const Remembered<T>& set = requests_.set_conc[chemical];
        for (std::size_t cell = 0; cell < set.present.size(); ++cell) {
            if (set.present[cell] != 0) conc[cell] = set.value[cell];
        }
        const T floor = in_precision<T>(phase.bounds[chemical].floor);
        const T limit = in_precision<T>(phase.bounds[chemical].limit);
        for (T& value : conc) value = clamped(value, floor, limit);
    }
}

template <class T>
void Cells<T>::confine(std::size_t cells) {
    const Domain& domain = experiment().domain;
    T half_width = in_precision<T>(domain.width / 2);
    T half_height = in_precision<T>(domain.height / 2);
    if (domain.packed) {
        const T area = static_cast<T>(cells) * in_precision<T>(domain.area);
        const T side = std::sqrt(area) - T(2);
        half_width = half_height = side / T(2);
    }
    for (T& x : next_.x) x = clamped(x, -half_width, half_width);
    for (T& y : next_.y) y = clamped(y, -half_height, half_height);
}

template <class T>
void Cells<T>::average_mirrors() {
    const auto average = [](std::vector<T>& values, std::size_t a, std::size_t b) {
        values[a] = values[b] = (values[a] + values[b]) / T(2);
    };
    for (const auto& [a, b] : next_.mirrors) {
        for (std::vector<T>& conc : next_.conc) average(conc, a, b);
        for (std::vector<T>& diff : next_.diff) average(diff, a, b);
    }
}

}  // namespace

}  // namespace reference

std::unique_ptr<Tissue> make_reference_cells(std::shared_ptr<const Experiment> experiment, const Snapshot& initial,
                                             Precision precision, NeighbourSearch search, SpatialSorting sorting) {
    if (precision == Precision::single_) {
        return std::make_unique<reference::Cells<float>>(std::move(experiment), initial, search, sorting);
    }
    return std::make_unique<reference::Cells<double>>(std::move(experiment), initial, search, sorting);
}

}  // namespace pelage
