// See locality.hpp.
#include "mesh/locality.hpp"

#include <algorithm>
#include <numeric>

namespace pelage {

namespace {

std::vector<std::uint32_t> identity(std::size_t count) {
    std::vector<std::uint32_t> ids(count);
    std::iota(ids.begin(), ids.end(), 0u);
    return ids;
}

}  // namespace

std::vector<std::uint32_t> locality_order(const Adjacency& adjacency) {
    const auto fewer = [&](std::uint32_t a, std::uint32_t b) {
        const std::size_t of_a = adjacency.count(a), of_b = adjacency.count(b);
        return of_a != of_b ? of_a < of_b : a < b;
    };
    std::vector<std::uint32_t> starts = identity(adjacency.cells());
    std::ranges::sort(starts, fewer);
    std::vector<std::uint8_t> taken(adjacency.cells(), 0);
    std::vector<std::uint32_t> order;
    order.reserve(adjacency.cells());
    for (const std::uint32_t start : starts) {
        if (taken[start] != 0) continue;
        taken[start] = 1;
        order.push_back(start);
        for (std::size_t done = order.size() - 1; done < order.size(); ++done) {
            const std::size_t first = order.size();
            const std::uint32_t cell = order[done];
            for (std::size_t entry = adjacency.offsets[cell]; entry < adjacency.offsets[cell + 1]; ++entry) {
                const std::uint32_t other = adjacency.indices[entry];
                if (other == Adjacency::nobody || taken[other] != 0) continue;
                taken[other] = 1;
                order.push_back(other);
            }
            std::sort(order.begin() + static_cast<std::ptrdiff_t>(first), order.end(), fewer);
        }
    }
    std::ranges::reverse(order);
    return order;
}

std::size_t bandwidth(const Adjacency& adjacency, const std::vector<std::uint32_t>& order) {
    std::vector<std::size_t> place(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) place[order[i]] = i;
    std::size_t widest = 0;
    for (std::size_t cell = 0; cell < adjacency.cells(); ++cell) {
        for (std::size_t entry = adjacency.offsets[cell]; entry < adjacency.offsets[cell + 1]; ++entry) {
            const std::size_t a = place[cell], b = place[adjacency.indices[entry]];
            widest = std::max(widest, a > b ? a - b : b - a);
        }
    }
    return widest;
}

}  // namespace pelage
