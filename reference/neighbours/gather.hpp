// What cells exchange with their neighbours in any space, neighbour after neighbour in the order of an Adjacency.
#pragma once

#include "core/adjacency.hpp"

#include <cmath>
#include <cstddef>
#include <vector>

namespace pelage::reference {

// The rate between two cells: 2 d1 d2 / (d1 + d2), so that an impermeable cell (0) exchanges nothing.
template <class T>
T shared_rate(T own, T theirs) {
    return own == theirs ? own : (T(2) * (own * theirs)) / (own + theirs);
}

// next[cell] += what the cell takes from its neighbours in a time step. `rates(entry)`: the rates of all cells, as felt
// along that entry's direction.
template <class T, class Rates>
void gather_cell(const Adjacency& adjacency, Arithmetic arithmetic, std::size_t cell, Rates rates, T dt,
                 const std::vector<T>& old, std::vector<T>& next) {
    for (std::size_t entry = adjacency.offsets[cell]; entry < adjacency.offsets[cell + 1]; ++entry) {
        const std::uint32_t there = adjacency.indices[entry];
        const bool outside = there == Adjacency::nobody;
        const std::vector<T>& felt = rates(entry);
        const T rate = outside ? felt[cell] : shared_rate(felt[cell], felt[there]);
        const T difference = (outside ? T(0) : old[there]) - old[cell];
        next[cell] = arithmetic == Arithmetic::published
                         ? next[cell] + ((rate * difference) * dt)
                         : std::fma((rate * dt) * static_cast<T>(adjacency.weights[entry]), difference, next[cell]);
    }
}

// All cells, with one rate each.
template <class T>
void gather(const Adjacency& adjacency, Arithmetic arithmetic, const std::vector<T>& rates, T dt,
            const std::vector<T>& old, std::vector<T>& next) {
    const auto same = [&](std::size_t) -> const std::vector<T>& { return rates; };
    for (std::size_t cell = 0; cell < adjacency.cells(); ++cell) {
        gather_cell(adjacency, arithmetic, cell, same, dt, old, next);
    }
}

}  // namespace pelage::reference
