// Where an aggregate's far field is kept: the same for every backend.
//
// A lattice is cut into square blocks, the leaves; four of them make a block of the next level, and so on until there
// are no more than two in a row and in a column. A charge adds to the candidates of its own leaf and of those beside it
// one by one. To any other candidate it adds in one block of one level: the largest that holds the candidate and is
// not beside the block of that level that holds the charge. Such a block keeps its sum at `far_nodes` times `far_nodes`
// nodes, between which a candidate interpolates.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pelage {

inline constexpr std::size_t far_nodes = 6;
inline constexpr std::size_t far_coefficients = far_nodes * far_nodes;

// What the far field adds to a potential is off by less than this part of it: the interpolation by 2^-12.5 where a
// charge lies nearest, the rounding of floats by far less.
inline constexpr double far_bound = 0x1p-12;

struct FarLevel {
    std::size_t side = 0;  // of a block, in sites: a power of two
    std::size_t columns = 0, rows = 0;
    std::size_t first = 0;  // the number of its first block; blocks are counted row by row, level by level
};

struct FarGrid {
    std::vector<FarLevel> levels;  // the leaves first
    std::size_t leaves() const { return levels.front().columns * levels.front().rows; }
    std::size_t blocks() const { return levels.back().first + levels.back().columns * levels.back().rows; }
};

// Small lattices have small leaves, so that they have a far field, too.
FarGrid far_grid(std::size_t columns, std::size_t rows);

// How many charges there were when the bounds of the blocks were last made anew: so often that every doubling of the
// charges does it 64 times.
constexpr std::uint64_t far_renewal(std::uint64_t charges) {
    const auto bits = static_cast<int>(std::bit_width(charges));
    return bits <= 7 ? charges : charges >> (bits - 7) << (bits - 7);
}

// The number of draws a choice may reject before it looks at all candidates.
constexpr std::uint64_t far_attempts(std::uint64_t candidates) { return candidates / 4 + 16; }

}  // namespace pelage
