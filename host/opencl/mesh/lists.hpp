// Who is whose neighbour on a mesh, as kernels/mesh/step.cl reads it: by place in the surface's order, in blocks.
#pragma once

#include "core/surface.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pelage {

// Cells of a block, whose lists are interleaved: entry k of the cell at place p is
// (rows[p / block] + k) * block + p % block.
constexpr std::size_t mesh_block = 16;

struct MeshLists {
    std::vector<std::uint32_t> rows{0};  // where the lists of a block begin; and the end of the last
    std::vector<std::int32_t> lengths;   // of each cell's list, and 0 for what fills the last block
    std::vector<std::uint32_t> indices;  // places; the cell itself where its list is over before the block's longest
    std::vector<double> weights;         // 0 there
};

// Neighbours are taken in the order that the surface's adjacency has them in. Throws Error where there are too many.
MeshLists mesh_lists(const MeshSurface&);

}  // namespace pelage
