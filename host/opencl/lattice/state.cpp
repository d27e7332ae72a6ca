// See state.hpp.
#include "opencl/lattice/state.hpp"

#include "core/fields.hpp"
#include "core/subnormal.hpp"
#include "opencl/lattice/emit_lattice.hpp"

#include <algorithm>

namespace pelage {

namespace {

bool reads_birth(const RuleUse& use) {
    return use.quantities.contains(Quantity::age) || use.quantities.contains(Quantity::birth);
}

std::vector<double> rounded(const std::vector<double>& values, bool is_double) {
    std::vector<double> result = values;
    for (double& value : result) value = is_double ? value : double{in_precision<float>(value)};
    return result;
}

// How many of the `reach` places around `at` lie within `count`, itself included.
std::size_t within(std::size_t at, std::size_t count, std::size_t reach) {
    return std::min(at, reach) + 1 + std::min(count - 1 - at, reach);
}

std::vector<std::int32_t> count_in_volume(const Volume& volume) {
    std::vector<std::int32_t> counts(volume.columns * volume.rows * volume.layers);
    const bool open = volume.boundary != Boundary::no_flux;
    for (std::size_t cell = 0; cell < counts.size(); ++cell) {
        const std::size_t line = cell / volume.columns;
        const std::size_t across = open ? 3 : within(cell % volume.columns, volume.columns, 1);
        const std::size_t up = open ? 3 : within(line % volume.rows, volume.rows, 1);
        const std::size_t deep = open ? 3 : within(line / volume.rows, volume.layers, 1);
        const bool faces = volume.stencil == Stencil::seven_point;
        counts[cell] = static_cast<std::int32_t>(faces ? across + up + deep - 3 : across * up * deep - 1);
    }
    return counts;
}

}  // namespace

LatticeState::LatticeState(const Session& session, const Experiment& experiment, const LatticePlan& plan,
                           const RuleUse& use, const Snapshot& initial)
    : session_(session),
      experiment_(experiment),
      plan_(plan),
      rate_planes_(rate_planes(plan)),
      grid_{initial.columns, initial.rows * std::max<std::size_t>(initial.layers, 1)},
      conc_(session, "concentrations", experiment.chemicals.size(), false),
      rates_(session, "diffusion rates", own_rates(plan), false),
      polarity_(session, "polarity", plan.polarity ? 2 : 0, false),
      mappings_(session, "mappings", experiment.mappings.size(), false),
      birth_(session, "birth", reads_birth(use) ? 1 : 0, true),
      neighbours_(session, "neighbour counts", use.quantities.contains(Quantity::neighbours) ? 1 : 0, true),
      fields_(session, "fields", experiment.fields.size(), false),
      expander_(session),
      resampler_(session),
      origin_x_(initial.origin_x),
      origin_y_(initial.origin_y),
      mirrors_(initial.mirrors) {
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
    if (birth_.planes() > 0) birth_.upload(grid_, std::vector<std::vector<std::uint32_t>>{initial.birth});
    if (neighbours_.planes() > 0) neighbours_.upload(grid_, std::vector<std::vector<std::int32_t>>{initial.neighbours});
    if (polarity_.planes() == 0) {
        kept_polarity_x_.take(rounded(initial.polarity_x, session.is_double()));
        kept_polarity_y_.take(rounded(initial.polarity_y, session.is_double()));
    }
    if (birth_.planes() == 0) kept_birth_.take(initial.birth);
    if (neighbours_.planes() == 0) kept_neighbours_.take(initial.neighbours);
    kept_fixed_.take(initial.fixed);
    for (std::size_t column = 0; column < grid_.columns; ++column) x_.push_back(initial.x[column]);
    for (std::size_t row = 0; row < grid_.rows; ++row) y_.push_back(initial.y[row * grid_.columns]);
    x_ = rounded(x_, session.is_double());
    y_ = rounded(y_, session.is_double());
    upload_places();
    fields();  // what is wrong with them shows before the run
}

Planes& LatticeState::fields() {
    if (fields_stale_) {
        const Precision precision = session_.is_double() ? Precision::double_ : Precision::single_;
        fields_.upload(grid_, field_values(experiment_, extent(), precision));
        fields_stale_ = false;
    }
    return fields_;
}

std::size_t LatticeState::rows() const { return plan_.volume() ? grid_.rows / plan_.layers : grid_.rows; }

Extent LatticeState::extent() const { return {grid_.columns, rows(), origin_x_, origin_y_, plan_.layers}; }

void LatticeState::upload_places() {
    const std::size_t count = grid_.pitch() + grid_.rows;
    std::vector<double> values(count, 0.0);
    std::copy(x_.begin(), x_.end(), values.begin());
    std::copy(y_.begin(), y_.end(), values.begin() + static_cast<std::ptrdiff_t>(grid_.pitch()));
    if (count > places_capacity_) {
        places_capacity_ = count + count / 2;
        places_ = session_.buffer(places_capacity_ * session_.scalar_bytes(), "places");
    }
    if (session_.is_double()) {
        session_.queue().enqueueWriteBuffer(places_, CL_TRUE, 0, count * 8, values.data());
    } else {
        const std::vector<float> singles(values.begin(), values.end());
        session_.queue().enqueueWriteBuffer(places_, CL_TRUE, 0, count * 4, singles.data());
    }
}

void LatticeState::set_rate(std::size_t chemical, double rate) {
    uniform_rates_[chemical] = session_.is_double() ? rate : double{in_precision<float>(rate)};
    if (rate_planes_[chemical] != no_plane) rates_.fill(grid_, rate_planes_[chemical], rate);
    ++rates_version_;
}

std::vector<std::int32_t> LatticeState::count_neighbours() const {
    std::vector<std::int32_t> counts(grid_.cells());
    if (plan_.volume()) return count_in_volume(plan_.as_volume());
    const bool five = plan_.stencil == Stencil::five_point;
    const auto reach = static_cast<std::size_t>(plan_.reach());
    for (std::size_t cell = 0; cell < counts.size(); ++cell) {
        const bool open = plan_.boundary != Boundary::no_flux;
        const std::size_t across = open ? 2 * reach + 1 : within(cell % grid_.columns, grid_.columns, reach);
        const std::size_t up = open ? 2 * reach + 1 : within(cell / grid_.columns, grid_.rows, reach);
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

void LatticeState::forget_counts() {
    if (counted_ && neighbours_.planes() == 0) kept_neighbours_.take(count_neighbours());
    counted_ = false;
    ++rates_version_;
}

void LatticeState::lay_out(const Grid& grid) {
    grid_ = grid;
    x_ = rounded(centres(origin_x_, grid_.columns), session_.is_double());
    y_ = rounded(centres(origin_y_, grid_.rows), session_.is_double());
    upload_places();
    fields_stale_ = true;  // an expansion comes column by column: they are computed when a step asks for them
}

void LatticeState::expand(const Insertion& insertion, std::uint64_t iteration) {
    forget_counts();
    const Grid after = grid_.grown(insertion.column);
    const auto birth = static_cast<std::uint32_t>(iteration);
    expander_.prepare(insertion);
    for (Planes* planes : {&conc_, &rates_, &polarity_, &mappings_, &birth_, &neighbours_}) {
        if (planes->planes() == 0) continue;
        planes->regrow(after, [&](const cl::Buffer& from, const cl::Buffer& to) {
            expander_.apply(from, to, grid_, planes->planes(), planes->integers(),
                            planes == &birth_ ? std::optional(birth) : std::nullopt);
        });
    }
    kept_polarity_x_.insert(grid_, insertion);
    kept_polarity_y_.insert(grid_, insertion);
    if (birth_.planes() == 0) kept_birth_.insert(grid_, insertion, birth);
    kept_neighbours_.insert(grid_, insertion);
    kept_fixed_.insert(grid_, insertion);
    lay_out(after);
}

void LatticeState::stretch(const Resampling& resampling, const std::vector<Bounds>& bounds) {
    forget_counts();
    resampler_.prepare(resampling, bounds);
    for (Planes* planes : {&conc_, &rates_, &polarity_, &mappings_, &birth_, &neighbours_}) {
        if (planes->planes() == 0) continue;
        planes->regrow(resampler_.after(), [&](const cl::Buffer& from, const cl::Buffer& to) {
            if (planes == &conc_) return resampler_.interpolate(from, to, grid_, planes->planes());
            resampler_.take_nearest(from, to, grid_, planes->planes(), planes->integers());
        });
    }
    kept_polarity_x_.stretch(grid_, resampling);
    kept_polarity_y_.stretch(grid_, resampling);
    kept_birth_.stretch(grid_, resampling);
    kept_neighbours_.stretch(grid_, resampling);
    kept_fixed_.stretch(grid_, resampling);
    lay_out(resampler_.after());
}

Snapshot LatticeState::read() const {
    const std::size_t cells = grid_.cells();
    Snapshot state;
    state.columns = grid_.columns;
    state.rows = rows();
    state.layers = plan_.layers;
    state.origin_x = origin_x_;
    state.origin_y = origin_y_;
    state.mirrors = mirrors_;
    state.conc = conc_.download<double>(grid_);
    auto rates = rates_.download<double>(grid_);
    for (std::size_t i = 0; i < plan_.rates.size(); ++i) {
        const bool own = rate_planes_[i] != no_plane;
        const double rate = session_.is_double() ? uniform_rates_[i] : double{in_precision<float>(uniform_rates_[i])};
        state.diff.push_back(own ? std::move(rates[rate_planes_[i]]) : std::vector<double>(grid_.cells(), rate));
    }
    state.mappings = mappings_.download<double>(grid_);
    for (std::size_t cell = 0; cell < cells; ++cell) {
        state.x.push_back(x_[cell % grid_.columns]);
        state.y.push_back(y_[cell / grid_.columns]);
    }
    if (polarity_.planes() > 0) {
        auto polarity = polarity_.download<double>(grid_);
        state.polarity_x = std::move(polarity[0]);
        state.polarity_y = std::move(polarity[1]);
    } else {
        state.polarity_x = kept_polarity_x_.of_all(cells);
        state.polarity_y = kept_polarity_y_.of_all(cells);
    }
    state.birth = birth_.planes() > 0 ? birth_.download<std::uint32_t>(grid_)[0] : kept_birth_.of_all(cells);
    state.neighbours = neighbours_.planes() > 0 ? neighbours_.download<std::int32_t>(grid_)[0]
                       : counted_               ? count_neighbours()
                                                : kept_neighbours_.of_all(cells);
    state.fixed = kept_fixed_.of_all(cells);
    return state;
}

}  // namespace pelage
