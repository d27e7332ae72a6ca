// See front.hpp.
#include "core/front.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace pelage {

Front::Front(const Snapshot& state, std::size_t order, std::string_view source, const std::vector<double>& open,
             std::optional<std::size_t> seed)
    : columns_(state.columns), rows_(state.rows) {
    if (columns_ > widest_aggregate || rows_ > widest_aggregate) {
        throw Error(fmt::format("{}: {} x {} sites; at most {} in a row or column are allowed", source, columns_, rows_,
                                widest_aggregate));
    }
    const std::vector<double>& arrived = state.conc[order];
    std::vector<std::uint32_t> seeds;
    for (std::uint32_t site = 0; site < arrived.size(); ++site) {
        if (arrived[site] > 0.0) seeds.push_back(site);
    }
    if (seeds.empty())
        throw Error(fmt::format("{}: no site holds a charge; give one the order 1 at the start", source));
    std::ranges::stable_sort(seeds, {}, [&](std::uint32_t site) { return arrived[site]; });
    sites_.assign(arrived.size(), free);
    for (std::size_t site = 0; site < open.size(); ++site) {
        if (open[site] == 0.0) sites_[site] = closed;
    }
    for (const std::uint32_t site : seeds) {
        const double told = seed ? state.conc[*seed][site] : 0.0;
        take_of(told != 0.0 ? told : static_cast<double>(charges_.size() + 1), site, 1.0f);
    }
    added_.clear();
}

void Front::take(std::uint32_t site, float size) {
    const std::int32_t place = sites_[site];
    const bool candidate = place >= 0;
    take_of(candidate ? parents_[static_cast<std::size_t>(place)] : static_cast<double>(charges_.size() + 1), site,
            size);
}

void Front::take_of(double seed, std::uint32_t site, float size) {
    added_.clear();
    if (sites_[site] >= 0) {
        places_[static_cast<std::size_t>(sites_[site])] = no_site;
        left_.push_back(static_cast<std::uint32_t>(sites_[site]));
    }
    sites_[site] = taken;
    charges_.push_back(site);
    seeds_.push_back(seed);
    sizes_.push_back(size);
    const std::size_t column = site % columns_, row = site / columns_;
    const std::size_t right = std::min(column + 2, columns_), top = std::min(row + 2, rows_);
    for (std::size_t x = column - std::min<std::size_t>(column, 1); x < right; ++x) {
        for (std::size_t y = row - std::min<std::size_t>(row, 1); y < top; ++y)
            add(static_cast<std::uint32_t>(y * columns_ + x));
    }
}

void Front::add(std::uint32_t site) {
    if (sites_[site] != free) return;
    std::uint32_t place = static_cast<std::uint32_t>(places_.size());
    if (left_.empty()) {
        places_.push_back(site);
        parents_.push_back(seeds_.back());
    } else {
        place = left_.back();
        left_.pop_back();
        places_[place] = site;
        parents_[place] = seeds_.back();
    }
    sites_[site] = static_cast<std::int32_t>(place);
    added_.push_back(place);
}

}  // namespace pelage
