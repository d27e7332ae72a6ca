// See state.hpp.
#include "opencl/lattice/state.hpp"

#include "core/fields.hpp"
#include "core/subnormal.hpp"
#include "opencl/lattice/emit_lattice.hpp"
#include "opencl/lattice/neighbour_counts.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

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

}  // namespace

LatticeState::LatticeState(const Session& session, const std::vector<LatticeStart>& starts, const LatticePlan& plan,
                           const RuleUse& use)
    : session_(session),
      members_(starts.size()),
      plan_(plan),
      rate_planes_(rate_planes(plan)),
      grid_{starts[0].state.columns, starts[0].state.rows * std::max<std::size_t>(starts[0].state.layers, 1)},
      conc_(planes_of("concentrations", starts[0].experiment.chemicals.size())),
      rates_(planes_of("diffusion rates", own_rates(plan))),
      polarity_(planes_of("polarity", plan.polarity ? 2 : 0)),
      mappings_(planes_of("mappings", starts[0].experiment.mappings.size())),
      birth_(planes_of("birth", reads_birth(use) ? 1 : 0, true)),
      neighbours_(planes_of("neighbour counts", use.quantities.contains(Quantity::neighbours) ? 1 : 0, true)),
      fields_(planes_of("fields", starts[0].experiment.fields.size())),
      expander_(session),
      resampler_(session),
      running_(starts.size()),
      origin_x_(starts[0].state.origin_x),
      origin_y_(starts[0].state.origin_y) {
    std::iota(running_.begin(), running_.end(), 0);
    for (std::size_t member = 0; member < starts.size(); ++member) take(member, starts[member]);
    lay_out_places(starts[0].state);
    fields();  // what is wrong with them shows before the run
}

Planes LatticeState::planes_of(const std::string& what, std::size_t of_a_member, bool integers) const {
    return {session_, what, of_a_member * members_.size(), integers};
}

void LatticeState::take(std::size_t member, const LatticeStart& start) {
    const Snapshot& initial = start.state;
    Member& kept = members_[member];
    kept.experiment = &start.experiment;
    conc_.upload(grid_, initial.conc, member * initial.conc.size());
    std::vector<std::vector<double>> rates;
    for (std::size_t i = 0; i < plan_.rates.size(); ++i) {
        if (plan_.rates[i] == RateKind::per_cell) rates.push_back(initial.diff[i]);
        kept.rates.push_back(initial.diff[i].front());
    }
    rates_.upload(grid_, rates, member * rates.size());
    mappings_.upload(grid_, initial.mappings, member * initial.mappings.size());
    if (polarity_.planes() > 0) {
        polarity_.upload(grid_, std::vector<std::vector<double>>{initial.polarity_x, initial.polarity_y}, 2 * member);
    } else {
        kept.kept.polarity_x.take(rounded(initial.polarity_x, session_.is_double()));
        kept.kept.polarity_y.take(rounded(initial.polarity_y, session_.is_double()));
    }
    if (birth_.planes() > 0) {
        birth_.upload(grid_, std::vector<std::vector<std::uint32_t>>{initial.birth}, member);
    } else {
        kept.kept.birth.take(initial.birth);
    }
    if (neighbours_.planes() > 0) {
        neighbours_.upload(grid_, std::vector<std::vector<std::int32_t>>{initial.neighbours}, member);
    } else {
        kept.kept.neighbours.take(initial.neighbours);
    }
    kept.kept.fixed.take(initial.fixed);
    kept.kept.mirrors = initial.mirrors;
}

void LatticeState::lay_out_places(const Snapshot& initial) {
    for (std::size_t column = 0; column < grid_.columns; ++column) x_.push_back(initial.x[column]);
    for (std::size_t row = 0; row < grid_.rows; ++row) y_.push_back(initial.y[row * grid_.columns]);
    x_ = rounded(x_, session_.is_double());
    y_ = rounded(y_, session_.is_double());
    upload_places();
}

Planes& LatticeState::fields() {
    if (!fields_stale_) return fields_;
    const Precision precision = session_.is_double() ? Precision::double_ : Precision::single_;
    for (std::size_t member = 0; member < members_.size(); ++member) {
        const auto values = field_values(*members_[member].experiment, extent(), precision);
        fields_.upload(grid_, values, member * values.size());
    }
    fields_stale_ = false;
    return fields_;
}

const cl::Buffer& LatticeState::running_list() {
    if (running_list_() == nullptr)
        running_list_ = session_.buffer(running_.size() * sizeof running_[0], "list of lattices");
    if (running_stale_)
        session_.queue().enqueueWriteBuffer(running_list_, CL_TRUE, 0, running_.size() * sizeof running_[0],
                                            running_.data());
    running_stale_ = false;
    return running_list_;
}

void LatticeState::end(std::size_t member) {
    std::erase(running_, static_cast<std::int32_t>(member));
    running_stale_ = true;
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

void LatticeState::set_rate(std::size_t chemical, double rate, std::size_t member) {
    members_[member].rates[chemical] = session_.is_double() ? rate : double{in_precision<float>(rate)};
    if (rate_planes_[chemical] != no_plane)
        rates_.fill(grid_, member * own_rates(plan_) + rate_planes_[chemical], rate);
    ++rates_version_;
}

void LatticeState::counted() {
    if (counted_) return;
    counted_ = true;
    for (std::size_t member = 0; member < neighbours_.planes(); ++member)
        neighbours_.upload(grid_, std::vector<std::vector<std::int32_t>>{neighbour_counts(plan_, grid_)}, member);
}

void LatticeState::forget_counts() {
    if (counted_ && neighbours_.planes() == 0) members_.front().kept.neighbours.take(neighbour_counts(plan_, grid_));
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
    members_.front().kept.insert(grid_, insertion, birth_.planes() == 0 ? std::optional(birth) : std::nullopt);
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
    members_.front().kept.stretch(grid_, resampling);
    lay_out(resampler_.after());
}

Snapshot LatticeState::read(std::size_t member) const {
    Snapshot state;
    state.columns = grid_.columns;
    state.rows = rows();
    state.layers = plan_.layers;
    state.origin_x = origin_x_;
    state.origin_y = origin_y_;
    const std::size_t cells = grid_.cells();
    for (std::size_t cell = 0; cell < cells; ++cell) {
        state.x.push_back(x_[cell % grid_.columns]);
        state.y.push_back(y_[cell / grid_.columns]);
    }
    const KeptCells& kept = members_[member].kept;
    state.mirrors = kept.mirrors;
    state.fixed = kept.fixed.of_all(cells);
    read_planes(member, state);
    if (polarity_.planes() == 0) {
        state.polarity_x = kept.polarity_x.of_all(cells);
        state.polarity_y = kept.polarity_y.of_all(cells);
    }
    if (birth_.planes() == 0) state.birth = kept.birth.of_all(cells);
    if (neighbours_.planes() == 0)
        state.neighbours = counted_ ? neighbour_counts(plan_, grid_) : kept.neighbours.of_all(cells);
    return state;
}

void LatticeState::read_planes(std::size_t member, Snapshot& state) const {
    const auto of = [&]<class V>(const Planes& planes, V) {
        const std::size_t count = planes.planes() / members_.size();
        return planes.download<V>(grid_, member * count, count);
    };
    state.conc = of(conc_, 0.0);
    auto own = of(rates_, 0.0);
    for (std::size_t i = 0; i < plan_.rates.size(); ++i) {
        const std::size_t plane = rate_planes_[i];
        const double uniform = members_[member].rates[i];
        const double rate = session_.is_double() ? uniform : double{in_precision<float>(uniform)};
        state.diff.push_back(plane != no_plane ? std::move(own[plane]) : std::vector<double>(grid_.cells(), rate));
    }
    state.mappings = of(mappings_, 0.0);
    if (polarity_.planes() > 0) {
        auto polarity = of(polarity_, 0.0);
        state.polarity_x = std::move(polarity[0]);
        state.polarity_y = std::move(polarity[1]);
    }
    if (birth_.planes() > 0) state.birth = of(birth_, std::uint32_t{})[0];
    if (neighbours_.planes() > 0) state.neighbours = of(neighbours_, std::int32_t{})[0];
}

}  // namespace pelage
