// Which values a condition's operands can have at all, and so whether it can ever hold.
#include "core/space.hpp"
#include "language/lints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <variant>

namespace pelage::language {

namespace {

struct Interval {  // both ends included
    double low = -infinity;
    double high = infinity;
    bool whole = false;  // no fractions

    void include(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
};

class Ranges {
public:
    Ranges(const Experiment& experiment, std::uint64_t first, std::uint64_t last)
        : experiment_(experiment), first_(static_cast<double>(first)), last_(static_cast<double>(last)) {}

    Interval of(const Operand& operand) const {
        switch (operand.quantity) {
            case Quantity::number:
                return {operand.value, operand.value, operand.value == std::floor(operand.value)};
            case Quantity::neighbours:
                return {0.0, infinity, true};
            case Quantity::age:
            case Quantity::birth:
                return {0.0, last_, true};
            case Quantity::iteration:
                return {first_, last_, true};
            case Quantity::time:
                return {experiment_.time_at(static_cast<std::uint64_t>(first_)), infinity, false};
            case Quantity::random:
                return {0.0, std::nextafter(1.0, 0.0), false};
            case Quantity::row:
            case Quantity::column:
            case Quantity::rows:
            case Quantity::columns:
            case Quantity::layer:
            case Quantity::layers:
                return of_grid(operand.quantity);
            case Quantity::concentration:
                return concentration(operand.index);
            case Quantity::mapping:
                return mapping(operand.index);
            case Quantity::x:
            case Quantity::y:
            case Quantity::z:
            case Quantity::rate:
            case Quantity::laplacian:
            case Quantity::gradient_x:
            case Quantity::gradient_y:
            case Quantity::gradient_z:
            case Quantity::stencil:
            case Quantity::field:
            case Quantity::expression:
                return {};
        }
        return {};
    }

private:
    Interval of_grid(Quantity quantity) const {
        const Space space = space_of(experiment_);
        if (!on_grid(space)) return {0.0, infinity, true};
        const bool grows = std::ranges::any_of(
            experiment_.rules, [](const Rule& rule) { return std::holds_alternative<Expand>(rule.action); });
        const bool place = quantity == Quantity::row || quantity == Quantity::column || quantity == Quantity::layer;
        const auto size = static_cast<double>(side(space, quantity));
        if (place) return {0.0, grows ? infinity : size - 1, true};
        return {size, grows ? infinity : size, true};
    }

    static std::size_t side(const Space& space, Quantity quantity) {
        const auto chosen = [&](std::size_t columns, std::size_t rows, std::size_t layers) {
            if (quantity == Quantity::layer || quantity == Quantity::layers) return layers;
            return quantity == Quantity::row || quantity == Quantity::rows ? rows : columns;
        };
        if (const auto* volume = std::get_if<Volume>(&space))
            return chosen(volume->columns, volume->rows, volume->layers);
        const auto& lattice = std::get<Lattice>(space);
        return chosen(lattice.columns, lattice.rows, 1);
    }

    Interval concentration(std::size_t chemical) const {
        Interval interval{infinity, -infinity, false};
        for (const Phase& phase : experiment_.phases) {
            interval.include(phase.bounds[chemical].floor);
            interval.include(phase.bounds[chemical].limit);
        }
        return interval;
    }

    Interval mapping(std::size_t index) const {
        Interval interval{0.0, 0.0, false};  // before its first `map`
        for (const Rule& rule : experiment_.rules) {
            const auto* map = std::get_if<Map>(&rule.action);
            if (map == nullptr || map->mapping != index) continue;
            interval.include(map->to_low);
            interval.include(map->to_high);
        }
        return interval;
    }

    const Experiment& experiment_;
    double first_, last_;
};

bool has_value(const Interval& one) { return !one.whole || std::ceil(one.low) <= one.high; }

bool meet(const Interval& one, const Interval& other) {
    const Interval both{std::max(one.low, other.low), std::min(one.high, other.high), one.whole || other.whole};
    return both.low <= both.high && has_value(both);
}

bool can_hold(const Interval& left, Comparison comparison, const Interval& right) {
    switch (comparison) {
        case Comparison::equal:
            return meet(left, right);
        case Comparison::not_equal:
            return left.low < left.high || right.low < right.high || left.low != right.low;
        case Comparison::less:
            return left.low < right.high;
        case Comparison::less_equal:
            return left.low <= right.high;
        case Comparison::greater:
            return left.high > right.low;
        case Comparison::greater_equal:
            return left.high >= right.low;
    }
    return true;
}

bool same(const Compare& compare) { return compare.left == compare.right && compare.left.quantity != Quantity::random; }

// As in "... is at least 0".
std::string shown(const Interval& one) {
    if (one.low == one.high) return fmt::format("{}", one.low);
    if (one.low == -infinity && one.high == infinity) return "any number";
    if (one.low == -infinity) return fmt::format("at most {}", one.high);
    if (one.high == infinity) return fmt::format("at least {}{}", one.low, one.whole ? ", whole" : "");
    return fmt::format("from {} to {}{}", one.low, one.high, one.whole ? ", whole" : "");
}

std::string why(const Ranges&, const Always&) { return ""; }

std::string why(const Ranges& ranges, const Compare& compare) {
    const Interval left = ranges.of(compare.left);
    const Interval right = ranges.of(compare.right);
    if (same(compare)) {
        if (can_hold({0, 0, true}, compare.comparison, {0, 0, true})) return "";
        return compare.left.quantity == Quantity::number ? "its expression is never true"
                                                         : "a value is compared with itself";
    }
    if (can_hold(left, compare.comparison, right)) return "";
    return fmt::format("the value compared is {}, the other one is {}", shown(left), shown(right));
}

std::string why(const Ranges& ranges, const Within& within) {
    const Interval value = ranges.of(within.value);
    const Interval low = ranges.of(within.low);
    const Interval high = ranges.of(within.high);
    if (low.low > high.high) return "the interval's low end is above its high end";
    if (meet(value, {low.low, high.high, false})) return "";
    return fmt::format("the value compared is {}, the interval is {}", shown(value),
                       shown({low.low, high.high, false}));
}

std::string why(const Ranges& ranges, const Probability& probability) {
    return ranges.of(probability.chance).high > 0.0 ? "" : "its probability is 0";
}

}  // namespace

std::string why_impossible(const Experiment& experiment, const Condition& condition, std::uint64_t first,
                           std::uint64_t last) {
    const Ranges ranges(experiment, first, last);
    return std::visit([&](const auto& one) { return why(ranges, one); }, condition);
}

}  // namespace pelage::language
