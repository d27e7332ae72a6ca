// See compare.hpp.
#include "verify/compare.hpp"

#include "core/columns.hpp"
#include "core/counted.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>

namespace pelage::verify {

namespace {

bool same_number(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) && !std::isnan(a);
}
template <class V>
bool same_number(const V& a, const V& b) {
    return a == b;
}

std::string with_bits(double value) { return fmt::format("{:a} ({})", value, value); }
template <std::integral V>
std::string with_bits(V value) {
    return std::to_string(value);
}
std::string with_bits(const std::pair<std::uint32_t, std::uint32_t>& pair) {
    return fmt::format("{} and {}", pair.first, pair.second);
}

class Comparer {
public:
    void columns(const std::string& name, const ColumnList& expected, const ColumnList& found) {
        if (expected.size() != found.size()) {
            lines.push_back(fmt::format("{}: {} arrays expected, {} found", name, expected.size(), found.size()));
            return;
        }
        for (std::size_t i = 0; i < expected.size(); ++i) {
            columns(fmt::format("{}[{}]", name, i), expected[i], found[i]);
        }
    }

    template <class V>
    void columns(const std::string& name, const std::vector<V>& expected, const std::vector<V>& found) {
        if (expected.size() != found.size()) {
            lines.push_back(
                fmt::format("{}: {} expected, {} found", name, counted(expected.size(), "element"), found.size()));
            return;
        }
        std::size_t count = 0;
        std::size_t first = 0;
        for (std::size_t i = expected.size(); i-- > 0;) {
            if (same_number(expected[i], found[i])) continue;
            ++count;
            first = i;
        }
        if (count == 0) return;
        lines.push_back(fmt::format("{}: {} of {} elements differ, first [{}]: {} expected, {} found", name, count,
                                    expected.size(), first, with_bits(expected[first]), with_bits(found[first])));
    }

    std::vector<std::string> lines;
};

}  // namespace

std::vector<std::string> differences(const Snapshot& expected, const Snapshot& found) {
    Comparer comparison;
    comparison.columns("shape", std::vector<std::uint64_t>{expected.iteration, expected.columns, expected.rows},
                       std::vector<std::uint64_t>{found.iteration, found.columns, found.rows});
    comparison.columns("origin", std::vector<double>{expected.origin_x, expected.origin_y},
                       std::vector<double>{found.origin_x, found.origin_y});
    each_column([&](const char* name, const auto& a, const auto& b) { comparison.columns(name, a, b); }, expected,
                found);
    return comparison.lines;
}

std::vector<std::string> mistrusted(const Snapshot& before, const Snapshot& after) {
    std::vector<std::string> lines;
    for (std::size_t chemical = 0; chemical < after.conc.size(); ++chemical) {
        const std::vector<double>& values = after.conc[chemical];
        const bool flat = std::all_of(values.begin(), values.end(), [&](double v) { return v == values.front(); });
        if (flat) lines.push_back(fmt::format("mistrusted: conc[{}] is flat", chemical));
        if (chemical < before.conc.size() && before.conc[chemical] == values) {
            lines.push_back(fmt::format("mistrusted: conc[{}] is as it was before", chemical));
        }
    }
    return lines;
}

}  // namespace pelage::verify
