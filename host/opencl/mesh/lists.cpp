// See lists.hpp.
#include "opencl/mesh/lists.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace pelage {

namespace {

std::vector<std::uint32_t> places_of(const MeshSurface& surface) {
    std::vector<std::uint32_t> place(surface.order.size());
    for (std::size_t i = 0; i < place.size(); ++i) place[surface.order[i]] = static_cast<std::uint32_t>(i);
    return place;
}

}  // namespace

MeshLists mesh_lists(const MeshSurface& surface) {
    const Adjacency& adjacency = surface.adjacency;
    const std::vector<std::uint32_t> place = places_of(surface);
    MeshLists lists;
    for (std::size_t begin = 0; begin < place.size(); begin += mesh_block) {
        const std::size_t cells = std::min(mesh_block, place.size() - begin);
        for (std::size_t i = 0; i < cells; ++i)
            lists.lengths.push_back(static_cast<std::int32_t>(adjacency.count(surface.order[begin + i])));
        lists.lengths.resize(begin + mesh_block, 0);
        const auto longest = static_cast<std::size_t>(
            *std::max_element(lists.lengths.end() - static_cast<std::ptrdiff_t>(mesh_block), lists.lengths.end()));
        for (std::size_t k = 0; k < longest; ++k) {
            for (std::size_t at = begin; at < begin + mesh_block; ++at) {
                const bool listed = k < static_cast<std::size_t>(lists.lengths[at]);
                const std::size_t entry = listed ? adjacency.offsets[surface.order[at]] + k : 0;
                lists.indices.push_back(listed ? place[adjacency.indices[entry]] : static_cast<std::uint32_t>(at));
                lists.weights.push_back(listed ? adjacency.weights[entry] : 0);
            }
        }
        const std::size_t rows = lists.indices.size() / mesh_block;
        if (rows > std::numeric_limits<std::uint32_t>::max())
            throw Error(fmt::format("{} rows of neighbours are more than a device can count", rows));
        lists.rows.push_back(static_cast<std::uint32_t>(rows));
    }
    return lists;
}

}  // namespace pelage
