// See aggregate.hpp.
#include "core/aggregate.hpp"

#include "core/counted.hpp"
#include "core/error.hpp"
#include "core/fields.hpp"
#include "core/inverse_root.hpp"
#include "core/philox.hpp"
#include "core/scene.hpp"
#include "core/space.hpp"
#include "core/stands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace pelage {

namespace {

constexpr double smallest_charge = 0.001;
constexpr double largest_charge = 1000.0;

double value_of(const Experiment& experiment, const Operand& operand, std::size_t rule, std::uint64_t iteration) {
    if (operand.quantity == Quantity::number) return operand.value;
    if (operand.quantity == Quantity::iteration) return static_cast<double>(iteration);
    if (operand.quantity == Quantity::time) return experiment.time_at(iteration);
    if (operand.quantity == Quantity::random) {
        const auto words = counted_words(iteration, 0, rule, purpose::charge_size, experiment.run_seed());
        return unit_uniform<double>(words[0]);
    }
    Snapshot now;
    now.iteration = iteration;
    Scene scene;
    scene.x = {0.0};
    scene.first = iteration;  // RANDOM is another one in each
    scene.seed = experiment.run_seed();
    scene.place = static_cast<std::uint32_t>(rule);
    scene.purpose = purpose::charge_size;
    scene.state = &now;
    scene.time = experiment.time_at(iteration);
    return evaluate(experiment.expressions.at(operand.index), scene).front();
}

class Reader {  // of one rule's parameters
public:
    Reader(const Experiment& experiment, std::size_t rule, std::uint64_t iteration)
        : experiment_(experiment), rule_(rule), iteration_(iteration) {}

    double read(const Operand& operand, const char* name, double low, double high) const {
        const double value = value_of(experiment_, operand, rule_, iteration_);
        if (value >= low && value <= high) return value;
        throw Error(
            fmt::format("{}: {} of 'aggregate' is {:.9g} at iteration {}; it must be a number from {:g} to {:g}",
                        experiment_.where(experiment_.rules[rule_].line), name, value, iteration_, low, high));
    }

private:
    const Experiment& experiment_;
    std::size_t rule_;
    std::uint64_t iteration_;
};

// The place of a coordinate among the centres of sites, which lie 2 apart.
float site_at(double coordinate, double origin, std::size_t count) {
    return static_cast<float>((coordinate - origin) / 2.0 + static_cast<double>(count - 1) / 2.0);
}

// The field that says which sites are open.
std::optional<std::size_t> mask_of(const Experiment& experiment) {
    for (const Statement& statement : experiment.prepattern) {
        if (const auto* made = std::get_if<CreateMatrix>(&statement)) return made->where;
    }
    return std::nullopt;
}

void check_open(const Experiment& experiment, const Snapshot& state, const std::vector<double>& order,
                const std::vector<double>& open) {
    std::size_t outside = 0, first = 0;
    for (std::size_t site = 0; site < open.size(); ++site) {
        if (open[site] != 0.0 || !(order[site] > 0.0)) continue;
        if (outside++ == 0) first = site;
    }
    if (outside == 0) return;
    const PlaceField& mask = experiment.fields[*mask_of(experiment)];
    const auto* computed = std::get_if<ComputedField>(&mask.source);
    throw Error(fmt::format(
        "{}: {} on sites that 'where' leaves out, the first in column {}, row {}; charges start where it is true alone",
        where_stands(experiment, mask.line, computed != nullptr ? computed->expression.text : "where"),
        counted(outside, "charge"), first % state.columns, first / state.columns));
}

// Where none is told it is 1.
std::vector<float> sizes_at_start(const Experiment& experiment, const Snapshot& state, std::size_t chemical,
                                  const Front& front) {
    std::vector<float> sizes;
    for (const std::uint32_t site : front.charges()) {
        const double told = state.conc[chemical][site];
        const float size = static_cast<float>(told);  // whatever the precision, a size is a float
        if (told != 0.0 &&
            !(size >= static_cast<float>(smallest_charge) && size <= static_cast<float>(largest_charge))) {
            throw Error(fmt::format(
                "{}: the charge in column {}, row {} starts with the size {:.9g}; it must be 0, which "
                "stands for 1, or a number from {:g} to {:g}",
                experiment.source, site % state.columns, site / state.columns, told, smallest_charge, largest_charge));
        }
        sizes.push_back(told == 0.0 ? 1.0f : size);
    }
    return sizes;
}

}  // namespace

std::uint64_t further_draw(const Particle& particle, std::uint64_t number) {
    const auto words = counted_words(number, particle.iteration, particle.rule, purpose::aggregation, particle.seed);
    return std::uint64_t{words[1]} << 32 | words[0];
}

bool has_charges(const Experiment& experiment) {
    const Space space = space_of(experiment);
    const auto* lattice = std::get_if<Lattice>(&space);
    return lattice != nullptr && lattice->charges;
}

const Aggregate& aggregate_of(const Experiment& experiment) {
    for (const Rule& rule : experiment.rules) {
        if (const auto* aggregate = std::get_if<Aggregate>(&rule.action)) return *aggregate;
    }
    throw Error(experiment.source + ": charges need a rule that says 'aggregate'");
}

Particle particle_at(const Experiment& experiment, std::size_t rule, std::uint64_t iteration, const Snapshot& state) {
    const auto& asked = std::get<Aggregate>(experiment.rules[rule].action);
    const Reader reader(experiment, rule, iteration);
    Particle particle;
    particle.eta = static_cast<float>(reader.read(asked.eta, "eta", 0.0, 100.0));
    const double radius = reader.read(asked.radius, "radius", 1e-6, 1e6);
    const double strength = reader.read(asked.strength, "strength", -1e6, 1e6);
    const double diagonal = std::hypot(static_cast<double>(state.columns), static_cast<double>(state.rows));
    const double pull = strength / radius * diagonal;
    if (std::abs(pull) > 0x1p30) {
        throw Error(
            fmt::format("{}: the strength {:g} over the radius {:g} of 'aggregate' is too much for this lattice",
                        experiment.where(experiment.rules[rule].line), strength, radius));
    }
    particle.pull = static_cast<float>(pull);
    particle.x = site_at(reader.read(asked.x, "x", -1e6, 1e6), state.origin_x, state.columns);
    particle.y = site_at(reader.read(asked.y, "y", -1e6, 1e6), state.origin_y, state.rows);
    particle.iteration = iteration;
    particle.rule = rule;
    particle.seed = experiment.run_seed();
    particle.draw = further_draw(particle, 0);
    if (asked.size)
        particle.size = static_cast<float>(reader.read(asked.grown, "size", smallest_charge, largest_charge));
    return particle;
}

std::vector<Arrival> arrivals(const Experiment& experiment, std::uint64_t first, std::uint64_t count,
                              const Snapshot& state) {
    std::vector<Arrival> found;
    for (std::uint64_t iteration = first; iteration < first + count; ++iteration) {
        for (std::size_t rule = 0; rule < experiment.rules.size(); ++rule) {
            if (!experiment.rules[rule].active(iteration)) continue;
            found.push_back({iteration, particle_at(experiment, rule, iteration, state)});
        }
    }
    return found;
}

std::vector<double> open_sites(const Experiment& experiment, const Snapshot& state) {
    const auto field = mask_of(experiment);
    if (!field) return {};
    return field_values(experiment, extent_of(state), Precision::double_).at(*field);
}

Front front_of(const Experiment& experiment, const Snapshot& state) {
    const Aggregate& aggregate = aggregate_of(experiment);
    const std::vector<double> open = open_sites(experiment, state);
    check_open(experiment, state, state.conc[aggregate.order], open);
    Front front(state, aggregate.order, experiment.source, open, aggregate.seed);
    if (aggregate.size) front.set_sizes(sizes_at_start(experiment, state, *aggregate.size, front));
    return front;
}

namespace {

template <class Value>
void show_of_charges(std::vector<double>& shown, const Front& front, const std::vector<Value>& values) {
    std::ranges::fill(shown, 0.0);
    for (std::size_t i = 0; i < values.size(); ++i) shown[front.charges()[i]] = double{values[i]};
}

}  // namespace

void show_aggregate(Snapshot& state, const Aggregate& aggregate, const Front& front,
                    const std::vector<std::int64_t>& sums) {
    std::vector<double>& order = state.conc[aggregate.order];
    std::vector<double>& potential = state.conc[aggregate.potential];
    order.assign(order.size(), 0.0);
    potential.assign(potential.size(), 0.0);
    double arrived = 0.0;
    for (const std::uint32_t site : front.charges()) order[site] = ++arrived;
    if (aggregate.seed) show_of_charges(state.conc[*aggregate.seed], front, front.seeds());
    if (aggregate.size) show_of_charges(state.conc[*aggregate.size], front, front.sizes());
    for (std::size_t place = 0; place < sums.size(); ++place) {
        const std::uint32_t site = front.places()[place];
        if (site != no_site) potential[site] = arrived - static_cast<double>(sums[place]) / inverse_parts;
    }
}

std::int64_t sum_at(std::uint32_t site, const Front& front) {
    std::int64_t sum = 0;
    const auto columns = static_cast<std::uint32_t>(front.columns());
    for (std::size_t i = 0; i < front.charges().size(); ++i)
        sum += inverse_distance(site, front.charges()[i], columns, front.sizes()[i]);
    return sum;
}

namespace {

// Whether some sums, evenly spread, are what the charges add up to.
bool sums_hold(const std::vector<std::int64_t>& sums, const Front& front) {
    if (sums.empty()) return true;
    constexpr std::size_t looked_at = 16;
    for (std::size_t i = 0; i < looked_at; ++i) {
        const std::size_t place = sums.size() * i / looked_at;
        const std::uint32_t site = front.places()[place];
        if (site != no_site && sum_at(site, front) != sums[place]) return false;
    }
    return true;
}

}  // namespace

std::vector<std::int64_t> told_sums(const Snapshot& state, const Aggregate& aggregate, const Front& front) {
    std::vector<std::int64_t> sums(front.places().size(), 0);
    const auto count = static_cast<double>(front.charges().size());
    for (std::size_t place = 0; place < sums.size(); ++place) {
        const std::uint32_t site = front.places()[place];
        if (site == no_site) continue;
        const double potential = state.conc[aggregate.potential][site];
        const double parts = (count - potential) * inverse_parts;
        if (!(std::abs(potential) < 0x1p23)) return {};  // beyond, a double cannot hold all parts
        if (!(parts > 0.0 && parts < 0x1p53) || parts != std::floor(parts)) return {};
        sums[place] = static_cast<std::int64_t>(parts);
    }
    if (!sums_hold(sums, front)) sums.clear();
    return sums;
}

}  // namespace pelage
