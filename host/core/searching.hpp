// The ability of a tissue of free cells to tell how well its neighbour search does.
#pragma once

#include "core/neighbours.hpp"
#include "core/tissue.hpp"

#include <optional>

namespace pelage {

class Searching {
public:
    virtual ~Searching() = default;

    // Of the latest iteration's search, counted when asked; empty where it is exact by construction.
    virtual std::optional<SearchStatistics> search_statistics() const = 0;
};

// Empty for a tissue that does not search, too.
inline std::optional<SearchStatistics> search_statistics(const Tissue& tissue) {
    const auto* searching = dynamic_cast<const Searching*>(&tissue);
    return searching == nullptr ? std::nullopt : searching->search_statistics();
}

}  // namespace pelage
