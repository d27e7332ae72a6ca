// A value of every cell that the device need not know, kept by the host: once, where it is the same for all cells.
#pragma once

#include "core/growth.hpp"
#include "opencl/planes.hpp"

#include <algorithm>
#include <cstddef>
#include <cstring>
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

    // One element of every row, or column, of `grid` is duplicated; see Insertion.
    void insert(const Grid& grid, const Insertion& insertion) {
        if (values_.empty()) return;
        const Grid after = grid.grown(insertion.column);
        std::vector<V> grown;
        grown.reserve(after.cells());
        for (std::size_t row = 0; row < after.rows; ++row) {
            for (std::size_t column = 0; column < after.columns; ++column) {
                const std::size_t pick = insertion.picks[insertion.column ? row : column];
                const std::size_t x = insertion.column && column > pick ? column - 1 : column;
                const std::size_t y = !insertion.column && row > pick ? row - 1 : row;
                grown.push_back(values_[y * grid.columns + x]);
            }
        }
        values_ = std::move(grown);
    }

private:
    V one_{};
    std::vector<V> values_;  // empty: one_ everywhere
};

}  // namespace pelage
