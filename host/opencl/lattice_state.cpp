// See lattice_state.hpp.
#include "opencl/lattice_state.hpp"

#include "opencl/emit_lattice.hpp"

#include <algorithm>

namespace pelage {

namespace {

std::size_t own_rates(const LatticePlan& plan) {
    return static_cast<std::size_t>(std::count(plan.rates.begin(), plan.rates.end(), RateKind::per_cell));
}

bool reads_birth(const RuleUse& use) {
    return use.quantities.contains(Quantity::age) || use.quantities.contains(Quantity::birth);
}

// A field's elements after an expansion; see Insertion.
template <class V>
void insert(std::vector<V>& field, const Grid& grid, const Insertion& insertion) {
    const Grid after = grid.grown(insertion.column);
    std::vector<V> grown;
    grown.reserve(after.cells());
    for (std::size_t row = 0; row < after.rows; ++row) {
        for (std::size_t column = 0; column < after.columns; ++column) {
            const std::size_t pick = insertion.picks[insertion.column ? row : column];
            const std::size_t x = insertion.column && column > pick ? column - 1 : column;
            const std::size_t y = !insertion.column && row > pick ? row - 1 : row;
            grown.push_back(field[y * grid.columns + x]);
        }
    }
    field = std::move(grown);
}

// Cells lie 2 apart around the centre, rounded to float as the published program holds them.
std::vector<double> centres(double origin, std::size_t count) {
    std::vector<double> values(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double offset = (static_cast<double>(i) - static_cast<double>(count) / 2.0) * 2 + 1;
        values[i] = static_cast<double>(static_cast<float>(origin + offset));
    }
    return values;
}

// How many of the `reach` places around `at` lie within `count`, itself included.
std::size_t within(std::size_t at, std::size_t count) { return (at > 0 ? 1u : 0u) + 1u + (at + 1 < count ? 1u : 0u); }

}  // namespace

LatticeState::LatticeState(const Session& session, const Experiment& experiment, const LatticePlan& plan,
                           const RuleUse& use, const Snapshot& initial)
    : session_(session),
      plan_(plan),
      rate_planes_(rate_planes(plan)),
      grid_{initial.columns, initial.rows},
      conc_(session, "concentrations", experiment.chemicals.size(), false),
      rates_(session, "diffusion rates", own_rates(plan), false),
      polarity_(session, "polarity", plan.polarity ? 2 : 0, false),
      mappings_(session, "mappings", experiment.mappings.size(), false),
      birth_(session, "birth", reads_birth(use) ? 1 : 0, true),
      neighbours_(session, "neighbour counts", use.quantities.contains(Quantity::neighbours) ? 1 : 0, true),
      expander_(session),
      kept_(initial) {
    conc_.upload(grid_, initial.conc);
    std::vector<std::vector<double>> rates;
    for (std::size_t i = 0; i < plan.rates.size(); ++i) {
        if (plan.rates[i] == RateKind::per_cell) rates.push_back(initial.diff[i]);
        uniform_rates_.push_back(initial.diff[i].front());
    }
    rates_.upload(grid_, rates);
    if (polarity_.planes() > 0)
        polarity_.upload(grid_, std::vector<std::vector<double>>{initial.polarity_x, initial.polarity_y});
    mappings_.upload(grid_, initial.mappings);
    if (birth_.planes() > 0) birth_.upload(grid_, std::vector<std::vector<std::int32_t>>{initial.birth});
    if (neighbours_.planes() > 0) neighbours_.upload(grid_, std::vector<std::vector<std::int32_t>>{initial.neighbours});
    for (auto* field : {&kept_.x, &kept_.y, &kept_.polarity_x, &kept_.polarity_y}) {
        for (double& value : *field) value = session.is_double() ? value : double{static_cast<float>(value)};
    }
    kept_.conc.clear();
    kept_.diff.clear();
    kept_.mappings.clear();
    kept_.x.resize(grid_.columns);
    for (std::size_t row = 0; row < grid_.rows; ++row) kept_.y[row] = kept_.y[row * grid_.columns];
    kept_.y.resize(grid_.rows);
    upload_places();
}

void LatticeState::upload_places() {
    const std::size_t count = grid_.pitch() + grid_.rows;
    std::vector<double> values(count, 0.0);
    std::copy(kept_.x.begin(), kept_.x.end(), values.begin());
    std::copy(kept_.y.begin(), kept_.y.end(), values.begin() + static_cast<std::ptrdiff_t>(grid_.pitch()));
    if (count > places_capacity_) {
        places_capacity_ = count + count / 2;
        places_ = session_.buffer(places_capacity_ * session_.scalar_bytes(), "places");
    }
    if (session_.is_double()) {
        session_.queue().enqueueWriteBuffer(places_, CL_TRUE, 0, count * 8, values.data());
    } else {
        const std::vector<float> rounded(values.begin(), values.end());
        session_.queue().enqueueWriteBuffer(places_, CL_TRUE, 0, count * 4, rounded.data());
    }
}

void LatticeState::set_rate(std::size_t chemical, double rate) {
    uniform_rates_[chemical] = session_.is_double() ? rate : static_cast<double>(static_cast<float>(rate));
    if (rate_planes_[chemical] != no_plane) rates_.fill(grid_, rate_planes_[chemical], rate);
}

std::vector<std::int32_t> LatticeState::count_neighbours() const {
    std::vector<std::int32_t> counts(grid_.cells());
    const bool five = plan_.stencil == Stencil::five_point;
    for (std::size_t cell = 0; cell < counts.size(); ++cell) {
        const bool open = plan_.boundary != Boundary::no_flux;
        const std::size_t across = open ? 3 : within(cell % grid_.columns, grid_.columns);
        const std::size_t up = open ? 3 : within(cell / grid_.columns, grid_.rows);
        counts[cell] = static_cast<std::int32_t>(five ? across + up - 2 : across * up - 1);
    }
    return counts;
}

void LatticeState::counted() {
    if (counted_) return;
    counted_ = true;
    if (neighbours_.planes() > 0) {
        neighbours_.upload(grid_, std::vector<std::vector<std::int32_t>>{count_neighbours()});
    }
}

void LatticeState::expand(const Insertion& insertion) {
    if (counted_ && neighbours_.planes() == 0) kept_.neighbours = count_neighbours();
    counted_ = false;
    const Grid after = grid_.grown(insertion.column);
    expander_.prepare(insertion);
    for (Planes* planes : {&conc_, &rates_, &polarity_, &mappings_, &birth_, &neighbours_}) {
        if (planes->planes() > 0) planes->expand(expander_, grid_, after);
    }
    if (polarity_.planes() == 0) {
        insert(kept_.polarity_x, grid_, insertion);
        insert(kept_.polarity_y, grid_, insertion);
    }
    if (birth_.planes() == 0) insert(kept_.birth, grid_, insertion);
    if (neighbours_.planes() == 0) insert(kept_.neighbours, grid_, insertion);
    insert(kept_.fixed, grid_, insertion);
    grid_ = after;
    kept_.x = centres(kept_.origin_x, grid_.columns);
    kept_.y = centres(kept_.origin_y, grid_.rows);
    upload_places();
}

Snapshot LatticeState::read() const {
    Snapshot state = kept_;
    state.columns = grid_.columns;
    state.rows = grid_.rows;
    state.conc = conc_.download<double>(grid_);
    auto rates = rates_.download<double>(grid_);
    for (std::size_t i = 0; i < plan_.rates.size(); ++i) {
        const bool own = rate_planes_[i] != no_plane;
        const double rate = session_.is_double() ? uniform_rates_[i] : double{static_cast<float>(uniform_rates_[i])};
        state.diff.push_back(own ? std::move(rates[rate_planes_[i]]) : std::vector<double>(grid_.cells(), rate));
    }
    state.mappings = mappings_.download<double>(grid_);
    state.x.clear();
    state.y.clear();
    for (std::size_t cell = 0; cell < grid_.cells(); ++cell) {
        state.x.push_back(kept_.x[cell % grid_.columns]);
        state.y.push_back(kept_.y[cell / grid_.columns]);
    }
    if (polarity_.planes() > 0) {
        auto polarity = polarity_.download<double>(grid_);
        state.polarity_x = std::move(polarity[0]);
        state.polarity_y = std::move(polarity[1]);
    }
    if (birth_.planes() > 0) state.birth = std::move(birth_.download<std::int32_t>(grid_)[0]);
    if (neighbours_.planes() > 0) state.neighbours = std::move(neighbours_.download<std::int32_t>(grid_)[0]);
    if (neighbours_.planes() == 0 && counted_) state.neighbours = count_neighbours();
    return state;
}

}  // namespace pelage
