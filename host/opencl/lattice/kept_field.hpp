// A value of every cell that the device need not know, kept by the host: once, where it is the same for all cells.
#pragma once

#include "core/growth.hpp"
#include "core/resampling.hpp"
#include "opencl/lattice/planes.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <utility>
#include <vector>

namespace pelage {

template <class V>
class KeptField {
public:
    void take(std::vector<V> values) {
        const auto same = [&](const V& value) { return std::memcmp(&value, &values.front(), sizeof value) == 0; };
        one_ = values.empty() ? V{} : values.front();
        if (std::all_of(values.begin(), values.end(), same)) {
            values_ = {};
        } else {
            values_ = std::move(values);
        }
    }

    std::vector<V> of_all(std::size_t cells) const { return values_.empty() ? std::vector<V>(cells, one_) : values_; }

    // One element of every row, or column, of `grid` is duplicated; see Insertion. A duplicate that is given a value
    // of its own takes that.
    void insert(const Grid& grid, const Insertion& insertion, std::optional<V> duplicate = std::nullopt) {
        if (values_.empty() && (!duplicate || *duplicate == one_)) return;
        const Grid after = grid.grown(insertion.column);
        std::vector<V> grown;
        grown.reserve(after.cells());
        for (std::size_t row = 0; row < after.rows; ++row) {
            for (std::size_t column = 0; column < after.columns; ++column) {
                const std::size_t pick = insertion.picks[insertion.column ? row : column];
                const std::size_t x = insertion.column && column > pick ? column - 1 : column;
                const std::size_t y = !insertion.column && row > pick ? row - 1 : row;
                const bool newborn = (insertion.column ? column : row) == pick + 1;
                grown.push_back(newborn && duplicate ? *duplicate : of(y * grid.columns + x));
            }
        }
        values_ = std::move(grown);
    }

    // Every cell takes the value of the nearest old one.
    void stretch(const Grid& grid, const Resampling& to) {
        if (values_.empty()) return;
        std::vector<V> grown;
        grown.reserve(to.across.places * to.up.places);
        for (const std::int32_t row : to.up.nearest) {
            const std::size_t start = static_cast<std::size_t>(row) * grid.columns;
            for (const std::int32_t column : to.across.nearest)
                grown.push_back(values_[start + static_cast<std::size_t>(column)]);
        }
        values_ = std::move(grown);
    }

private:
    const V& of(std::size_t cell) const { return values_.empty() ? one_ : values_[cell]; }

    V one_{};
    std::vector<V> values_;  // empty: one_ everywhere
};

}  // namespace pelage
