// See tally.hpp.
#include "verify/tally.hpp"

#include "core/columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <vector>

namespace pelage::verify {

namespace {

constexpr std::uint64_t endless = std::numeric_limits<std::uint64_t>::max();

// Numbers in the order of the values they stand for, one apart where the values are neighbours.
template <class Bits, class Real>
std::int64_t rank(Real value) {
    const auto bits = std::bit_cast<Bits>(value);
    constexpr Bits sign = Bits{1} << (8 * sizeof(Bits) - 1);
    const auto magnitude = static_cast<std::int64_t>(bits & ~sign);
    return (bits & sign) != 0 ? -magnitude : magnitude;
}

bool same_or_both_nan(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) || (std::isnan(a) && std::isnan(b));
}

std::string shown(double value, Precision precision) {
    if (precision == Precision::double_)
        return fmt::format("{:.17g} (0x{:016x})", value, std::bit_cast<std::uint64_t>(value));
    const auto single = static_cast<float>(value);
    return fmt::format("{:.9g} (0x{:08x})", single, std::bit_cast<std::uint32_t>(single));
}

// One pass over the arrays of two states; cells that differ are marked.
class Pass {
public:
    Pass(Tally& tally, const Snapshot& expected, Precision precision, const std::string& where)
        : tally_(tally), precision_(precision), where_(where), columns_(expected.columns), differs_(expected.cells()) {}

    void shape(const std::string& what, std::uint64_t expected, std::uint64_t found) {
        if (expected == found) return;
        whole_ = false;
        tally_.same_structure = false;
        if (tally_.first.empty()) {
            tally_.first = fmt::format("{}: {} is {}, expected {}", where_, what, found, expected);
        }
    }

    void column(const std::string& name, const std::vector<double>& expected, const std::vector<double>& found) {
        shape("the number of values of " + name, expected.size(), found.size());
        tally_.found.add(found.data(), found.size() * sizeof(double));
        for (std::size_t i = 0; i < std::min(expected.size(), found.size()); ++i) {
            if (same_or_both_nan(expected[i], found[i])) continue;
            measure(expected[i], found[i]);
            mark(i, name, shown(expected[i], precision_), shown(found[i], precision_));
        }
    }

    template <class V>
    void column(const std::string& name, const std::vector<V>& expected, const std::vector<V>& found) {
        shape("the number of values of " + name, expected.size(), found.size());
        tally_.found.add(found.data(), found.size() * sizeof(V));
        for (std::size_t i = 0; i < std::min(expected.size(), found.size()); ++i) {
            if (expected[i] == found[i]) continue;
            tally_.same_structure = false;
            mark(i, name, std::to_string(expected[i]), std::to_string(found[i]));
        }
    }

    void column(const std::string& name, const ColumnList& expected, const ColumnList& found) {
        shape("the number of planes of " + name, expected.size(), found.size());
        for (std::size_t i = 0; i < std::min(expected.size(), found.size()); ++i) {
            column(fmt::format("{}[{}]", name, i), expected[i], found[i]);
        }
    }

    void column(const std::string& name, const PairColumn& expected, const PairColumn& found) {
        shape("the number of " + name, expected.size(), found.size());
        for (std::size_t i = 0; i < std::min(expected.size(), found.size()); ++i) {
            if (expected[i] != found[i]) shape(fmt::format("the first cell of {}[{}]", name, i), 0, 1);
        }
    }

    void finish() {
        tally_.cells_compared += differs_.size();
        const auto count = std::ranges::count(differs_, true);
        tally_.cells_differing += whole_ ? static_cast<std::uint64_t>(count) : differs_.size();
        if (!first_.empty() && tally_.first.empty()) tally_.first = where_ + ": " + first_;
    }

private:
    void measure(double expected, double found) {
        tally_.max_ulp = std::max(tally_.max_ulp, ulps(expected, found, precision_));
        const double difference = std::abs(expected - found);
        if (!std::isfinite(difference)) {
            tally_.max_absolute = tally_.max_relative = tally_.max_scaled = std::numeric_limits<double>::infinity();
            return;
        }
        tally_.max_absolute = std::max(tally_.max_absolute, difference);
        tally_.max_scaled = std::max(tally_.max_scaled, difference / std::max(1.0, std::abs(expected)));
        if (expected != 0) tally_.max_relative = std::max(tally_.max_relative, difference / std::abs(expected));
    }

    void mark(std::size_t cell, const std::string& name, const std::string& expected, const std::string& found) {
        if (cell < differs_.size()) differs_[cell] = true;
        if (!first_.empty()) return;
        const std::string place =
            columns_ == 0 ? "" : fmt::format(" (row {}, column {})", cell / columns_, cell % columns_);
        first_ = fmt::format("{} of cell {}{} is {}, expected {}", name, cell, place, found, expected);
    }

    Tally& tally_;
    Precision precision_;
    const std::string& where_;
    std::size_t columns_;
    std::vector<bool> differs_;
    bool whole_ = true;
    std::string first_;
};

template <class V, class Show>
void add_values(Tally& tally, std::span<const V> expected, std::span<const V> found, const std::string& what,
                const Show& show) {
    const std::size_t common = std::min(expected.size(), found.size());
    tally.found.add(found.data(), found.size_bytes());
    tally.cells_compared += expected.size();
    if (expected.size() != found.size()) {
        tally.cells_differing += std::max(expected.size(), found.size()) - common;
        if (tally.first.empty()) {
            tally.first = fmt::format("{}: {} values, expected {}", what, found.size(), expected.size());
        }
    }
    for (std::size_t i = 0; i < common; ++i) {
        if (!show.differ(expected[i], found[i])) continue;
        ++tally.cells_differing;
        if (tally.first.empty()) {
            tally.first =
                fmt::format("{} [{}] is {}, expected {}", what, i, show.text(found[i]), show.text(expected[i]));
        }
    }
}

struct Reals {
    Tally& tally;
    Precision precision;
    bool differ(double expected, double found) const {
        if (same_or_both_nan(expected, found)) return false;
        tally.max_ulp = std::max(tally.max_ulp, ulps(expected, found, precision));
        tally.max_absolute = std::max(tally.max_absolute, std::abs(expected - found));
        return true;
    }
    std::string text(double value) const { return shown(value, precision); }
};

struct WholeNumbers {
    bool differ(std::uint32_t expected, std::uint32_t found) const { return expected != found; }
    std::string text(std::uint32_t value) const { return fmt::format("0x{:08x}", value); }
};

}  // namespace

std::uint64_t ulps(double expected, double found, Precision precision) {
    if (same_or_both_nan(expected, found)) return 0;
    if (std::isnan(expected) || std::isnan(found)) return endless;
    const bool single = precision == Precision::single_;
    const std::int64_t a = single ? rank<std::uint32_t>(static_cast<float>(expected)) : rank<std::uint64_t>(expected);
    const std::int64_t b = single ? rank<std::uint32_t>(static_cast<float>(found)) : rank<std::uint64_t>(found);
    return a > b ? static_cast<std::uint64_t>(a) - static_cast<std::uint64_t>(b)
                 : static_cast<std::uint64_t>(b) - static_cast<std::uint64_t>(a);
}

void add(Tally& tally, const Snapshot& expected, const Snapshot& found, Precision precision, const std::string& where) {
    Pass pass(tally, expected, precision, where);
    pass.shape("the iteration", expected.iteration, found.iteration);
    pass.shape("the number of columns", expected.columns, found.columns);
    pass.shape("the number of rows", expected.rows, found.rows);
    each_column([&](const char* name, const auto& a, const auto& b) { pass.column(name, a, b); }, expected, found);
    pass.finish();
}

void add(Tally& tally, std::span<const float> expected, std::span<const float> found, const std::string& what) {
    add_values(tally, expected, found, what, Reals{tally, Precision::single_});
}

void add(Tally& tally, std::span<const double> expected, std::span<const double> found, const std::string& what) {
    add_values(tally, expected, found, what, Reals{tally, Precision::double_});
}

void add(Tally& tally, std::span<const std::uint32_t> expected, std::span<const std::uint32_t> found,
         const std::string& what) {
    add_values(tally, expected, found, what, WholeNumbers{});
}

}  // namespace pelage::verify
