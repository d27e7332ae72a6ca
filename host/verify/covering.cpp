// See covering.hpp.
#include "verify/covering.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <span>

namespace pelage::verify {

namespace {

constexpr std::size_t open = std::numeric_limits<std::size_t>::max();  // no value has been chosen

// Which tuples have been met: a bit for each value of each set of `strength` factors.
class Tuples {
public:
    explicit Tuples(const Array& array) : factors_(array.factors) {
        std::vector<std::size_t> set(array.strength);
        with_.resize(factors_.size());
        fill(set, 0, 0, array.wanted);
        for (const auto& of_set : sets_) met_.emplace_back(count(of_set), false);
    }

    std::size_t sets() const { return sets_.size(); }
    const std::vector<std::size_t>& set(std::size_t nth) const { return sets_[nth]; }
    std::size_t size(std::size_t nth) const { return met_[nth].size(); }
    bool met(std::size_t nth, std::size_t tuple) const { return met_[nth][tuple]; }
    void mark(std::size_t nth, std::size_t tuple) { met_[nth][tuple] = true; }

    std::vector<Choice> choices(std::size_t nth, std::size_t tuple) const {
        std::vector<Choice> made(sets_[nth].size());
        for (std::size_t i = made.size(); i-- > 0;) {
            const std::size_t factor = sets_[nth][i];
            made[i] = {factor, tuple % values(factor)};
            tuple /= values(factor);
        }
        return made;
    }

    // The number of the tuple that the row holds; nothing where one of its factors is open.
    std::optional<std::size_t> held(std::size_t nth, const ArrayRow& row) const {
        std::size_t tuple = 0;
        for (const std::size_t factor : sets_[nth]) {
            if (row[factor] == open) return {};
            tuple = tuple * values(factor) + row[factor];
        }
        return tuple;
    }

    void mark(const ArrayRow& row) {
        for (std::size_t nth = 0; nth < sets(); ++nth) {
            if (const auto tuple = held(nth, row)) mark(nth, *tuple);
        }
    }

    // Tuples with that factor that the row would be the first to hold.
    std::size_t gain(const ArrayRow& row, std::size_t factor) const {
        std::size_t sum = 0;
        for (const std::size_t nth : with_[factor]) {
            const auto tuple = held(nth, row);
            if (tuple && !met(nth, *tuple)) ++sum;
        }
        return sum;
    }

private:
    std::size_t values(std::size_t factor) const { return factors_[factor].values.size(); }

    std::size_t count(const std::vector<std::size_t>& set) const {
        std::size_t product = 1;
        for (const std::size_t factor : set) product *= values(factor);
        return product;
    }

    void fill(std::vector<std::size_t>& set, std::size_t place, std::size_t from,
              const std::function<bool(const std::vector<std::size_t>&)>& wanted) {
        if (place == set.size()) {
            if (wanted && !wanted(set)) return;
            for (const std::size_t factor : set) with_[factor].push_back(sets_.size());
            sets_.push_back(set);
            return;
        }
        for (std::size_t factor = from; factor < factors_.size(); ++factor) {
            set[place] = factor;
            fill(set, place + 1, factor + 1, wanted);
        }
    }

    const std::vector<Factor>& factors_;
    std::vector<std::vector<std::size_t>> sets_;
    std::vector<std::vector<std::size_t>> with_;  // for each factor, the sets that it is in
    std::vector<std::vector<bool>> met_;
};

class Generator {
public:
    explicit Generator(const Array& array)
        : array_(array), tuples_(array), given_used_(array.given.size(), 0), dice_(array.draw) {
        for (const Factor& factor : array.factors) used_.emplace_back(factor.values.size(), 0);
        order_.resize(array.factors.size());
        std::iota(order_.begin(), order_.end(), std::size_t{0});
        ArrayRow row(array.factors.size(), open);
        given_factors_ = array.given.empty() ? 0 : array.given.front().size();
        for (const ArrayRow& given : array.given) {
            std::ranges::copy(given, row.begin());
            tuples_.mark(row);
        }
    }

    Covering run() {
        for (std::size_t nth = 0; nth < tuples_.sets(); ++nth) {
            for (std::size_t tuple = 0; tuple < tuples_.size(nth); ++tuple) {
                if (!tuples_.met(nth, tuple)) begin(nth, tuple);
            }
        }
        return std::move(made_);
    }

private:
    bool among_given(std::size_t nth) const { return tuples_.set(nth).back() < given_factors_; }

    void begin(std::size_t nth, std::size_t tuple) {
        shuffle();
        ArrayRow row(array_.factors.size(), open);
        bool possible = !among_given(nth);
        for (const Choice& choice : tuples_.choices(nth, tuple)) {
            possible = possible && fits(row, choice);
            row[choice.factor] = choice.value;
        }
        if (possible && complete(row)) {
            keep(row);
        } else {
            ++made_.infeasible;
            tuples_.mark(nth, tuple);
        }
    }

    // The order in which open factors take their values, drawn anew for each row.
    void shuffle() {
        for (std::size_t i = order_.size(); array_.draw != 0 && i > 1; --i) {
            dice_ = dice_ * 6364136223846793005u + 1442695040888963407u;
            std::swap(order_[i - 1], order_[(dice_ >> 33) % i]);
        }
    }

    void keep(const ArrayRow& row) {
        tuples_.mark(row);
        for (std::size_t factor = 0; factor < row.size(); ++factor) ++used_[factor][row[factor]];
        made_.rows.push_back(row);
        if (given_factors_ == 0) return;
        const auto same = [&](const ArrayRow& given) { return std::equal(given.begin(), given.end(), row.begin()); };
        const auto which = std::ranges::find_if(array_.given, same) - array_.given.begin();
        made_.of_given.push_back(static_cast<std::size_t>(which));
        ++given_used_[static_cast<std::size_t>(which)];
    }

    bool fits(const ArrayRow& row, const Choice& choice) const {
        for (std::size_t factor = 0; factor < row.size(); ++factor) {
            if (row[factor] == open || factor == choice.factor) continue;
            if (!array_.feasible({factor, row[factor]}, choice)) return false;
        }
        return true;
    }

    // Fills what is open; false: no way to.
    bool complete(ArrayRow& row) {
        const auto agreeing = [&](const ArrayRow& given) { return agrees(row, given); };
        if (given_factors_ != 0 && std::ranges::none_of(array_.given, agreeing)) return false;
        const auto at = std::ranges::find_if(
            order_, [&](std::size_t factor) { return factor >= given_factors_ && row[factor] == open; });
        if (at == order_.end()) return begin_as_given(row);
        const std::size_t factor = *at;
        for (const std::size_t value : by_gain(row, factor)) {
            row[factor] = value;
            if (complete(row)) return true;
        }
        row[factor] = open;
        return false;
    }

    // Values that fit, the one with which most new tuples meet first; among equals the one used least.
    std::vector<std::size_t> by_gain(ArrayRow row, std::size_t factor) const {
        struct Candidate {
            std::size_t gain, used, value;
        };
        std::vector<Candidate> candidates;
        for (std::size_t value = 0; value < used_[factor].size(); ++value) {
            if (!fits(row, {factor, value})) continue;
            row[factor] = value;
            candidates.push_back({tuples_.gain(row, factor), used_[factor][value], value});
            row[factor] = open;
        }
        std::ranges::stable_sort(candidates, [](const Candidate& a, const Candidate& b) {
            return a.gain != b.gain ? a.gain > b.gain : a.used < b.used;
        });
        std::vector<std::size_t> values;
        for (const Candidate& candidate : candidates) values.push_back(candidate.value);
        return values;
    }

    // Takes the values of the first factors from the given row that adds most for what it costs.
    bool begin_as_given(ArrayRow& row) const {
        if (given_factors_ == 0) return true;
        std::optional<std::size_t> best;
        std::size_t most = 0;
        for (std::size_t which = 0; which < array_.given.size(); ++which) {
            if (!agrees(row, array_.given[which])) continue;
            const std::size_t gain = gain_with(row, array_.given[which]);
            const std::size_t mine = gain * (best ? array_.costs[*best] : 1), theirs = most * array_.costs[which];
            const bool better = !best || mine > theirs || (mine == theirs && spent(which) < spent(*best));
            if (!better) continue;
            best = which;
            most = gain;
        }
        if (best) std::ranges::copy(array_.given[*best], row.begin());
        return best.has_value();
    }

    std::size_t spent(std::size_t given) const { return given_used_[given] * array_.costs[given]; }

    bool agrees(const ArrayRow& row, const ArrayRow& given) const {
        for (std::size_t factor = 0; factor < given.size(); ++factor) {
            if (row[factor] != open && row[factor] != given[factor]) return false;
            for (std::size_t other = given.size(); other < row.size(); ++other) {
                if (row[other] == open) continue;
                if (!array_.feasible({factor, given[factor]}, {other, row[other]})) return false;
            }
        }
        return true;
    }

    std::size_t gain_with(ArrayRow row, const ArrayRow& given) const {
        std::ranges::copy(given, row.begin());
        std::size_t sum = 0;
        for (std::size_t factor = 0; factor < given.size(); ++factor) sum += tuples_.gain(row, factor);
        return sum;
    }

    const Array& array_;
    Tuples tuples_;
    Covering made_;
    std::size_t given_factors_ = 0;
    std::vector<std::size_t> given_used_;
    std::vector<std::vector<std::size_t>> used_;  // how often a value is in a row
    std::vector<std::size_t> order_;
    std::uint64_t dice_;
};

// Drops rows all of whose tuples other rows hold too: of the dearest first, then of the latest.
class Pruner {
public:
    Pruner(const Array& array, Covering& made) : array_(array), tuples_(array), made_(made) {
        for (std::size_t nth = 0; nth < tuples_.sets(); ++nth) counts_.emplace_back(tuples_.size(nth), 0);
        given_factors_ = array.given.empty() ? 0 : array.given.front().size();
        for (const ArrayRow& row : made.rows) count(row, 1);
    }

    void run() {
        std::vector<std::size_t> order(made_.rows.size());
        std::iota(order.rbegin(), order.rend(), std::size_t{0});
        std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return cost(a) > cost(b); });
        std::vector<bool> dropped(order.size(), false);
        for (const std::size_t row : order) {
            if (!superfluous(made_.rows[row])) continue;
            dropped[row] = true;
            count(made_.rows[row], -1);
        }
        drop(made_.rows, dropped);
        drop(made_.of_given, dropped);
    }

private:
    template <class T>
    static void drop(std::vector<T>& from, const std::vector<bool>& dropped) {
        std::vector<T> left;
        for (std::size_t i = 0; i < from.size(); ++i) {
            if (!dropped[i]) left.push_back(from[i]);
        }
        from = std::move(left);
    }

    std::size_t cost(std::size_t row) const { return given_factors_ == 0 ? 0 : array_.costs[made_.of_given[row]]; }

    void count(const ArrayRow& row, int change) {
        for (std::size_t nth = 0; nth < tuples_.sets(); ++nth) counts_[nth][*tuples_.held(nth, row)] += change;
    }

    bool superfluous(const ArrayRow& row) const {
        for (std::size_t nth = 0; nth < tuples_.sets(); ++nth) {
            if (tuples_.set(nth).back() < given_factors_) continue;
            if (counts_[nth][*tuples_.held(nth, row)] < 2) return false;
        }
        return true;
    }

    const Array& array_;
    Tuples tuples_;
    Covering& made_;
    std::size_t given_factors_ = 0;
    std::vector<std::vector<int>> counts_;  // how many rows hold a tuple
};

// Any two of the choices fit each other, and to all of them fits some value of every other factor.
bool feasible(const Array& array, std::span<const Choice> choices) {
    const auto fits = [&](const Choice& one) {
        return std::ranges::all_of(choices, [&](const Choice& other) {
            return one.factor == other.factor ? one.value == other.value : array.feasible(one, other);
        });
    };
    for (std::size_t factor = 0; factor < array.factors.size(); ++factor) {
        bool any = false;
        for (std::size_t value = 0; value < array.factors[factor].values.size(); ++value)
            any = any || fits({factor, value});
        if (!any) return false;
    }
    return true;
}

}  // namespace

Covering cover(const Array& array) {
    Covering made = Generator(array).run();
    Pruner(array, made).run();
    return made;
}

std::vector<std::string> not_met(const Array& array, const std::vector<ArrayRow>& rows) {
    Tuples tuples(array);
    for (ArrayRow row : rows) {
        row.resize(array.factors.size(), open);
        tuples.mark(row);
    }
    std::vector<std::string> missing;
    for (std::size_t nth = 0; nth < tuples.sets(); ++nth) {
        for (std::size_t tuple = 0; tuple < tuples.size(nth); ++tuple) {
            const std::vector<Choice> choices = tuples.choices(nth, tuple);
            if (tuples.met(nth, tuple) || !feasible(array, choices)) continue;
            std::string text;
            for (const Choice& choice : choices) {
                const Factor& factor = array.factors[choice.factor];
                text += (text.empty() ? "" : ", ") + factor.name + " " + factor.values[choice.value];
            }
            missing.push_back(text);
        }
    }
    return missing;
}

}  // namespace pelage::verify
