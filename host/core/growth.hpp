// Growth of a lattice by expansion: which element of each row or column is duplicated.
#pragma once

#include "core/experiment.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pelage {

// One inserted column (or row). picks[i] is the element of row i (column i) that is duplicated in place;
// its successors shift by one.
struct Insertion {
    bool column = true;
    std::vector<std::uint32_t> picks;
};

// The picks of one insertion into a columns x rows matrix, drawn by Philox4x32-10 with key `seed` and counter
// (line, iteration, rule, purpose + 16 * nth): equal on every backend. `nth` counts the insertions of one expansion.
// shuffled: a random permutation of the places, dealt out line by line; uniform; normal: mean in the middle,
// deviation a sixth of the length, clipped; triangular: rising to the middle and falling (2020 paper, figure 3).
Insertion draw_insertion(const Expand&, bool column, std::size_t columns, std::size_t rows, std::int64_t seed,
                         std::uint64_t iteration, std::size_t rule, std::size_t nth);

}  // namespace pelage
