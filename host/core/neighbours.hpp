// Who is whose neighbour among free cells, how they are searched for, and how much an approximate search misses.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace pelage {

inline constexpr double interaction_range = 3.0;  // in units of cell radius; strictly nearer cells are neighbours

// Compressed rows: the neighbours of cell i are ids[first[i]] .. ids[first[i + 1] - 1], ascending, without i itself.
struct Neighbours {
    std::vector<std::size_t> first;  // cells + 1 entries
    std::vector<std::uint32_t> ids;

    std::size_t cells() const { return first.empty() ? 0 : first.size() - 1; }
    std::span<const std::uint32_t> of(std::size_t cell) const& {
        return std::span(ids).subspan(first[cell], first[cell + 1] - first[cell]);
    }
    std::span<const std::uint32_t> of(std::size_t cell) && = delete;  // it would outlive what it shows
    bool operator==(const Neighbours&) const = default;
};

enum class NeighbourSearch {
    bins,            // exact: sorted into bins on a device
    kd_tree,         // exact: the same sets as bins
    spatial_sorting  // approximate, see SpatialSorting
};

// The search of Malheiros & Walter (2015; 2017, section 4), as their program does it. Cells lie in a square matrix of
// side ceil(sqrt(cells)), row after row: cell i at place i to begin with, children at the places behind in order of
// id, and behind them coordinates larger than any. A wider side re-cuts the same sequence into longer rows.
// At the start of each iteration the places take the cells' positions and rounds of odd-even transposition follow:
// in every row swap places (1, 2), (3, 4), ... where the left x is greater, then (0, 1), (2, 3), ...; in every column
// alike by y, upper place against lower. The rounds end with the first one that swaps nothing, or after `rounds`.
// Neighbours are those cells of the square window around a place with d2 <= 9, taken in ascending id.
struct SpatialSorting {
    std::size_t window = 48;  // places around a cell that are looked at: 8, 24, 48, 80 or 120
    std::size_t rounds = 0;   // a round more changes nothing once the matrix is sorted; 0: until it is
};

// What a search found against the exact sets; `+=` joins the counts of several iterations.
struct SearchStatistics {
    std::uint64_t iterations = 0;         // that were counted
    std::uint64_t cells = 0;              // summed over these iterations
    std::uint64_t neighbours_exact = 0;   // i of j and j of i are two
    std::uint64_t neighbours_missed = 0;  // of these
    std::uint64_t cells_with_misses = 0;
    std::uint64_t most_missed = 0;  // of one cell

    // Missed share of the exact neighbours, 0..1.
    double miss_rate() const {
        return neighbours_exact == 0 ? 0.0
                                     : static_cast<double>(neighbours_missed) / static_cast<double>(neighbours_exact);
    }
    SearchStatistics& operator+=(const SearchStatistics& other) {
        iterations += other.iterations;
        cells += other.cells;
        neighbours_exact += other.neighbours_exact;
        neighbours_missed += other.neighbours_missed;
        cells_with_misses += other.cells_with_misses;
        most_missed = std::max(most_missed, other.most_missed);
        return *this;
    }
};

}  // namespace pelage
