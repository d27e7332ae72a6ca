// See aggregate.hpp.
#include "core/aggregate.hpp"

#include "core/error.hpp"
#include "core/inverse_root.hpp"
#include "core/philox.hpp"
#include "core/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pelage {

namespace {

double value_of(const Experiment& experiment, const Operand& operand, std::uint64_t iteration) {
    if (operand.quantity == Quantity::number) return operand.value;
    if (operand.quantity == Quantity::iteration) return static_cast<double>(iteration);
    if (operand.quantity == Quantity::time) return experiment.time_at(iteration);
    Snapshot now;
    now.iteration = iteration;
    Scene scene;
    scene.x = {0.0};
    scene.state = &now;
    scene.time = experiment.time_at(iteration);
    return evaluate(experiment.expressions.at(operand.index), scene).front();
}

class Reader {  // of one rule's parameters
public:
    Reader(const Experiment& experiment, std::size_t rule, std::uint64_t iteration)
        : experiment_(experiment), line_(experiment.rules[rule].line), iteration_(iteration) {}

    double read(const Operand& operand, const char* name, double low, double high) const {
        const double value = value_of(experiment_, operand, iteration_);
        if (value >= low && value <= high) return value;
        throw Error(
            fmt::format("{}: {} of 'aggregate' is {:.9g} at iteration {}; it must be a number from {:g} to {:g}",
                        experiment_.where(line_), name, value, iteration_, low, high));
    }

private:
    const Experiment& experiment_;
    std::size_t line_;
    std::uint64_t iteration_;
};

// The place of a coordinate among the centres of sites, which lie 2 apart.
float site_at(double coordinate, double origin, std::size_t count) {
    return static_cast<float>((coordinate - origin) / 2.0 + static_cast<double>(count - 1) / 2.0);
}

std::uint64_t draw_of(const Experiment& experiment, std::size_t rule, std::uint64_t iteration) {
    const auto words = counted_words(0, iteration, rule, purpose::aggregation, experiment.run_seed());
    return std::uint64_t{words[1]} << 32 | words[0];
}

}  // namespace

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
    particle.draw = draw_of(experiment, rule, iteration);
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

Front::Front(const Snapshot& state, std::size_t order, std::string_view source)
    : columns_(state.columns), rows_(state.rows) {
    if (columns_ > widest_aggregate || rows_ > widest_aggregate) {
        throw Error(fmt::format("{}: {} x {} sites; at most {} in a row or column are allowed", source, columns_, rows_,
                                widest_aggregate));
    }
    const std::vector<double>& arrived = state.conc[order];
    std::vector<std::uint32_t> seeds;
    for (std::uint32_t site = 0; site < arrived.size(); ++site) {
        if (arrived[site] > 0.0) seeds.push_back(site);
    }
    if (seeds.empty())
        throw Error(fmt::format("{}: no site holds a charge; give one the order 1 at the start", source));
    std::ranges::stable_sort(seeds, {}, [&](std::uint32_t site) { return arrived[site]; });
    sites_.assign(arrived.size(), free);
    for (const std::uint32_t site : seeds) take(site);
    added_.clear();
}

void Front::take(std::uint32_t site) {
    added_.clear();
    if (sites_[site] >= 0) {
        places_[static_cast<std::size_t>(sites_[site])] = no_site;
        left_.push_back(static_cast<std::uint32_t>(sites_[site]));
    }
    sites_[site] = taken;
    charges_.push_back(site);
    const std::size_t column = site % columns_, row = site / columns_;
    const std::size_t right = std::min(column + 2, columns_), top = std::min(row + 2, rows_);
    for (std::size_t x = column - std::min<std::size_t>(column, 1); x < right; ++x) {
        for (std::size_t y = row - std::min<std::size_t>(row, 1); y < top; ++y)
            add(static_cast<std::uint32_t>(y * columns_ + x));
    }
}

void Front::add(std::uint32_t site) {
    if (sites_[site] != free) return;
    std::uint32_t place = static_cast<std::uint32_t>(places_.size());
    if (left_.empty()) {
        places_.push_back(site);
    } else {
        place = left_.back();
        left_.pop_back();
        places_[place] = site;
    }
    sites_[site] = static_cast<std::int32_t>(place);
    added_.push_back(place);
}

void show_aggregate(Snapshot& state, const Aggregate& aggregate, const Front& front,
                    const std::vector<std::int64_t>& sums) {
    std::vector<double>& order = state.conc[aggregate.order];
    std::vector<double>& potential = state.conc[aggregate.potential];
    order.assign(order.size(), 0.0);
    potential.assign(potential.size(), 0.0);
    double arrived = 0.0;
    for (const std::uint32_t site : front.charges()) order[site] = ++arrived;
    for (std::size_t place = 0; place < sums.size(); ++place) {
        const std::uint32_t site = front.places()[place];
        if (site != no_site) potential[site] = arrived - static_cast<double>(sums[place]) / inverse_parts;
    }
}

std::int64_t sum_at(std::uint32_t site, const Front& front) {
    std::int64_t sum = 0;
    for (const std::uint32_t charge : front.charges())
        sum += inverse_distance(site, charge, static_cast<std::uint32_t>(front.columns()));
    return sum;
}

namespace {

// Whether some sums, evenly spread, are what the charges add up to.
bool sums_hold(const std::vector<std::int64_t>& sums, const Front& front) {
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
        const double parts = (count - state.conc[aggregate.potential][site]) * inverse_parts;
        if (!(parts > 0.0 && parts < 0x1p53) || parts != std::floor(parts)) return {};
        sums[place] = static_cast<std::int64_t>(parts);
    }
    if (!sums_hold(sums, front)) sums.clear();
    return sums;
}

}  // namespace pelage
