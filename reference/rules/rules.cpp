// The rule interpreter: a rule's condition becomes one truth a cell, then its action is carried out where that holds.
#include "reference/rules/rules.hpp"

#include "core/philox.hpp"
#include "core/subnormal.hpp"
#include "reference/rules/neural.hpp"
#include "reference/rules/operands.hpp"
#include "reference/rules/reactions.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

namespace pelage::reference {

namespace {

template <class T>
struct Judge {  // narrows truth to the cells where a condition holds
    Sight<T>& sight;
    std::vector<std::uint8_t>& truth;

    void operator()(const Always&) {}
    void operator()(const Compare& c) {
        if (compared_exactly(c.left, c.right)) return exactly(c.left, c.comparison, c.right);
        const Column<T> left = sight.column(c.left);
        const Column<T> right = sight.column(c.right);
        narrow([&](std::size_t cell) { return holds(left[cell], c.comparison, right[cell]); });
    }
    void operator()(const Within& c) {
        const bool low_exact = compared_exactly(c.low, c.value);
        const bool high_exact = compared_exactly(c.value, c.high);
        if (low_exact) exactly(c.low, Comparison::less_equal, c.value);
        if (high_exact) exactly(c.value, Comparison::less_equal, c.high);
        if (low_exact && high_exact) return;
        const Column<T> value = sight.column(c.value);
        if (!low_exact) {
            const Column<T> low = sight.column(c.low);
            narrow([&](std::size_t cell) { return low[cell] <= value[cell]; });
        }
        if (!high_exact) {
            const Column<T> high = sight.column(c.high);
            narrow([&](std::size_t cell) { return value[cell] <= high[cell]; });
        }
    }
    void operator()(const Probability& c) {
        const Column<T> chance = sight.column(c.chance);
        narrow([&](std::size_t cell) { return draw(sight, cell, purpose::condition) < chance[cell]; });
    }

    void exactly(const Operand& a, Comparison comparison, const Operand& b) {
        const Column<double> left = sight.exact_column(a);
        const Column<double> right = sight.exact_column(b);
        narrow([&](std::size_t cell) { return holds(left[cell], comparison, right[cell]); });
    }

    template <class F>
    void narrow(F&& condition) {
        for (std::size_t cell = 0; cell < truth.size(); ++cell) {
            if (truth[cell] != 0) truth[cell] = condition(cell) ? 1 : 0;
        }
    }
};

template <class T>
struct Act {  // carries out an action where truth holds
    Sight<T>& sight;
    Arithmetic arithmetic;
    T dt;
    State<T>& next;
    Requests<T>& requests;
    std::vector<Remembered<T>>& set_rate;

    void operator()(const React& react) { react_cells(react, arithmetic, dt, sight, next, requests.truth); }

    void operator()(const Formula& formula) {
        for (const Formula::Part& part : formula.parts) {
            const Column<T> rate = sight.column(part.rate);
            std::vector<T>& values = next.conc[part.chemical];
            if (arithmetic == Arithmetic::published) {
                each([&](std::size_t cell) { values[cell] = values[cell] + rate[cell] * dt; });
            } else {
                each([&](std::size_t cell) { values[cell] = std::fma(dt, rate[cell], values[cell]); });
            }
        }
    }

    void operator()(const Neural& neural) {
        const std::size_t count = neural.species.size();
        const Column<T> rate = sight.column(neural.rate);
        const Column<T> diffusion = sight.column(neural.diffusion);
        std::vector<const T*> old;
        for (const std::size_t chemical : neural.species) old.push_back(sight.old.conc[chemical].data());
        const std::vector<std::vector<T>> f = ask(*neural.network, old, next.cells());
        for (std::size_t i = 0; i < count; ++i) {
            std::vector<T>& values = next.conc[neural.species[i]];
            if (!neural.still()) {
                const T share = static_cast<T>(group_rate(i, count));
                const std::vector<T> lap = sight.ground.laplacian(sight.old.conc[neural.species[i]]);
                each([&](std::size_t cell) {
                    values[cell] = std::fma((diffusion[cell] * dt) * share, lap[cell], values[cell]);
                });
            }
            each([&](std::size_t cell) { values[cell] = std::fma(rate[cell] * dt, f[i][cell], values[cell]); });
        }
    }

    void operator()(const Change& change) {
        const Column<T> amount = sight.column(change.amount);
        const T deviation = in_precision<T>(change.deviation);
        const bool rate = change.target == Target::rate;
        std::vector<T>& values = (rate ? next.diff : next.conc)[change.chemical];
        each([&](std::size_t cell) {
            values[cell] = values[cell] + deviated(amount[cell], deviation, cell);
            if (rate && values[cell] < T(0)) values[cell] = T(0);
        });
    }

    void operator()(const Set& set) {
        const Column<T> value = sight.column(set.value);
        Remembered<T>& memory = (set.target == Target::rate ? set_rate : requests.set_conc)[set.chemical];
        memory.prepare(next.cells());
        each([&](std::size_t cell) {
            memory.value[cell] = value[cell];
            memory.present[cell] = 1;
        });
    }

    void operator()(const Map& map) {
        const Column<T> value = sight.column(map.value);
        const T from_low = in_precision<T>(map.from_low), from_high = in_precision<T>(map.from_high);
        const T to_low = in_precision<T>(map.to_low), to_high = in_precision<T>(map.to_high);
        std::vector<T>& mapping = next.mappings[map.mapping];
        each([&](std::size_t cell) {
            const T x = value[cell];
            mapping[cell] = x < from_low    ? to_low
                            : x > from_high ? to_high
                                            : ((x - from_low) / (from_high - from_low)) * (to_high - to_low) + to_low;
        });
    }

    void operator()(const Polarize& polarize) {
        if (requests.polarize.empty()) requests.polarize.assign(next.cells(), -1);
        each([&](std::size_t cell) { requests.polarize[cell] = static_cast<std::int32_t>(polarize.chemical); });
    }

    void operator()(const Divide& divide) {
        const Column<T> direction = sight.column(divide.direction);
        const T deviation = in_precision<T>(divide.deviation);
        each([&](std::size_t cell) {
            requests.divisions.push_back({cell, sight.rule, double{deviated(direction[cell], deviation, cell)}});
        });
    }

    void operator()(const Move& move) {
        const Column<T> distance = sight.column(move.distance);
        const T deviation = in_precision<T>(move.deviation);
        each([&](std::size_t cell) {
            const T offset = deviated(distance[cell], deviation, cell);
            next.x[cell] = next.x[cell] + sight.old.polarity_x[cell] * offset;
            next.y[cell] = next.y[cell] + sight.old.polarity_y[cell] * offset;
        });
    }

    void operator()(const And&) {}        // truth is handed on by apply_rules
    void operator()(const Expand&) {}     // growth comes before the iteration, in Tissue::advance
    void operator()(const Aggregate&) {}  // charges are a tissue of their own: reference/aggregate/tissue.cpp

    T deviated(T value, T deviation, std::size_t cell) const {
        if (deviation == T(0)) return value;
        const T u = draw(sight, cell, purpose::deviation);
        return value + deviation * ((u + u) - T(1));
    }

    template <class F>
    void each(F&& action) {
        for (std::size_t cell = 0; cell < requests.truth.size(); ++cell) {
            if (requests.truth[cell] != 0) action(cell);
        }
    }
};

template <class T>
void replace_rates(const std::vector<Remembered<T>>& sets, State<T>& next) {
    for (std::size_t chemical = 0; chemical < sets.size(); ++chemical) {
        const Remembered<T>& set = sets[chemical];
        for (std::size_t cell = 0; cell < set.present.size(); ++cell) {
            if (set.present[cell] != 0) next.diff[chemical][cell] = set.value[cell] < T(0) ? T(0) : set.value[cell];
        }
    }
}

}  // namespace

template <class T>
void Remembered<T>::prepare(std::size_t cells) {
    if (!empty()) return;
    value.assign(cells, T(0));
    present.assign(cells, 0);
}

template <class T>
void apply_rules(const Experiment& experiment, std::uint64_t iteration, Arithmetic arithmetic, const Ground<T>& ground,
                 const State<T>& old, State<T>& next, Requests<T>& requests) {
    const T dt = in_precision<T>(experiment.phase_at(iteration).time_step);
    const std::int64_t seed = experiment.run_seed();
    std::vector<Remembered<T>> set_rate(next.diff.size());
    requests.set_conc.assign(next.conc.size(), {});
    requests.polarize.clear();
    requests.divisions.clear();

    bool handed = false;  // the rule before was an `and`: truth holds what it found
    for (std::size_t place = 0; place < experiment.rules.size(); ++place) {
        const Rule& rule = experiment.rules[place];
        const bool conjunction = std::holds_alternative<And>(rule.action);
        if (!rule.active(iteration)) {
            if (conjunction) requests.truth.assign(old.cells(), 0);
            handed = conjunction;
            continue;
        }
        if (!handed) requests.truth.assign(old.cells(), 1);
        handed = conjunction;
        Sight<T> sight{experiment, old, next.mappings, ground, iteration, seed, place};
        std::visit(Judge<T>{sight, requests.truth}, rule.condition);
        std::visit(Act<T>{sight, arithmetic, dt, next, requests, set_rate}, rule.action);
    }
    replace_rates(set_rate, next);
}

template struct Remembered<float>;
template struct Remembered<double>;
template void apply_rules(const Experiment&, std::uint64_t, Arithmetic, const Ground<float>&, const State<float>&,
                          State<float>&, Requests<float>&);
template void apply_rules(const Experiment&, std::uint64_t, Arithmetic, const Ground<double>&, const State<double>&,
                          State<double>&, Requests<double>&);

}  // namespace pelage::reference
