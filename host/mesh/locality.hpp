// Numbering for caches: vertices that exchange lie near each other in memory.
#pragma once

#include "core/adjacency.hpp"

#include <cstdint>
#include <vector>

namespace pelage {

// The cells in an order in which neighbours are near each other (reverse Cuthill-McKee 1969): the first entry is the
// cell that comes first. Every part that hangs together begins with its cell of fewest neighbours, the lowest of equal
// ones.
std::vector<std::uint32_t> locality_order(const Adjacency&);

// The farthest that two neighbours are apart in an order.
std::size_t bandwidth(const Adjacency&, const std::vector<std::uint32_t>& order);

}  // namespace pelage
