// The state of a tissue as the reference computes with it: one array a quantity, in the precision of the run.
#pragma once

#include "core/snapshot.hpp"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace pelage::reference {

// Cells in id order; ids as in core/snapshot.hpp. Lengths in units of cell radius.
template <class T>
struct State {
    std::size_t columns = 0;  // 0 for free cells
    std::size_t rows = 0;
    std::size_t layers = 0;  // of a volume
    double origin_x = 0.0;
    double origin_y = 0.0;

    std::vector<std::vector<T>> conc;      // [chemical][cell]
    std::vector<std::vector<T>> diff;      // [chemical][cell]
    std::vector<std::vector<T>> mappings;  // [mapping][cell]
    std::vector<T> x, y;
    std::vector<T> polarity_x, polarity_y;
    std::vector<std::uint32_t> birth;
    std::vector<std::int32_t> neighbours;  // as counted in the previous iteration
    std::vector<std::uint8_t> fixed;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> mirrors;

    std::size_t cells() const { return x.size(); }
};

template <class T>
State<T> state_from(const Snapshot&);

template <class T>
Snapshot snapshot_from(const State<T>&);  // all but the iteration

}  // namespace pelage::reference
