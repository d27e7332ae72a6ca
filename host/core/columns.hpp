// The columns of a snapshot, listed once: whoever writes, compares, checks or picks them goes through this list.
#pragma once

#include "core/snapshot.hpp"

#include <cstdint>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace pelage {

using ColumnList = std::vector<std::vector<double>>;                      // [chemical or mapping][cell]
using PairColumn = std::vector<std::pair<std::uint32_t, std::uint32_t>>;  // of cells; not one entry a cell

// Calls visit(NAME, column...) for each column, with that of each of the states, which are snapshots. A column is a
// ColumnList, a PairColumn, or a std::vector with one value a cell; `order` is one, with no value for the cells that
// are not in it. They come as in a checkpoint file.
template <class Visit, class... States>
void each_column(Visit&& visit, States&... states) {
    visit("x", states.x...);
    visit("y", states.y...);
    visit("conc", states.conc...);
    visit("diff", states.diff...);
    visit("mappings", states.mappings...);
    visit("polarity_x", states.polarity_x...);
    visit("polarity_y", states.polarity_y...);
    visit("birth", states.birth...);
    visit("neighbours", states.neighbours...);
    visit("fixed", states.fixed...);
    visit("mirrors", states.mirrors...);
    visit("order", states.order...);
}

// The same for the columns with one value a cell alone, those of a ColumnList one by one.
template <class Visit, class State>
void each_cell_column(Visit&& visit, State& state) {
    each_column(
        [&]<class Column>(const char* name, Column& column) {
            if constexpr (std::is_same_v<std::remove_const_t<Column>, ColumnList>) {
                for (auto& one : column) visit(name, one);
            } else if constexpr (!std::is_same_v<std::remove_const_t<Column>, PairColumn>) {
                if (std::string_view(name) != "order") visit(name, column);
            }
        },
        state);
}

}  // namespace pelage
