// See far_growth.hpp.
#include "reference/aggregate/far_growth.hpp"

#include "core/inverse_root.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace pelage::reference {

namespace {

constexpr std::int64_t none_yet = std::numeric_limits<std::int64_t>::max();

// A sum less what floats may have rounded it up by.
std::int64_t surely(std::int64_t sum) { return sum - (sum >> 16); }

}  // namespace

FarGrowth::FarGrowth(Front front)
    : front_(std::move(front)),
      field_(far_grid(front_.columns(), front_.rows())),
      leaves_(field_.grid().leaves()),
      sites_(front_.sites().size(), Front::free),
      lowest_(none_yet) {
    for (std::size_t site = 0; site < sites_.size(); ++site) {
        if (front_.sites()[site] == Front::closed) sites_[site] = Front::closed;
    }
    const std::uint64_t renewed = far_renewal(front_.charges().size());
    for (std::size_t i = 0; i < front_.charges().size(); ++i) {
        add(front_.charges()[i], front_.sizes()[i]);
        if (charges_ == renewed) renew();
    }
}

FarCharge FarGrowth::charge_at(std::uint32_t site, float size) const {
    const std::size_t columns = front_.columns();
    return {static_cast<std::int32_t>(site % columns), static_cast<std::int32_t>(site / columns), size};
}

std::size_t FarGrowth::leaf_of(std::uint32_t site) const {
    const FarLevel& cut = field_.grid().levels.front();
    return site / front_.columns() / cut.side * cut.columns + site % front_.columns() / cut.side;
}

// The leaf of a site and those beside it, row by row.
template <class Visit>
void FarGrowth::each_near(std::uint32_t site, Visit&& visit) const {
    const FarLevel& cut = field_.grid().levels.front();
    const std::size_t x = leaf_of(site) % cut.columns, y = leaf_of(site) / cut.columns;
    for (std::size_t row = y - std::min<std::size_t>(y, 1); row < std::min(y + 2, cut.rows); ++row) {
        for (std::size_t column = x - std::min<std::size_t>(x, 1); column < std::min(x + 2, cut.columns); ++column)
            visit(row * cut.columns + column);
    }
}

std::int64_t FarGrowth::far_sum(std::uint32_t site) const {
    const FarCharge place = charge_at(site, 1.0f);
    return field_.at(place.x, place.y);
}

void FarGrowth::take(std::uint32_t site, float size) {
    front_.take(site, size);
    add(site, size);
    if (charges_ == far_renewal(charges_)) renew();
}

void FarGrowth::add(std::uint32_t site, float size) {
    if (sites_[site] == 0) remove(site);
    sites_[site] = Front::taken;
    ++charges_;
    leaves_[leaf_of(site)].charges.push_back(charge_at(site, size));
    pull_near(site, size);
    field_.add(charge_at(site, size));
    const std::size_t columns = front_.columns(), x = site % columns, y = site / columns;
    for (std::size_t i = x - std::min<std::size_t>(x, 1); i < std::min(x + 2, columns); ++i) {
        for (std::size_t j = y - std::min<std::size_t>(y, 1); j < std::min(y + 2, front_.rows()); ++j)
            offer(static_cast<std::uint32_t>(j * columns + i));
    }
}

// The last candidate of the leaf takes its place.
void FarGrowth::remove(std::uint32_t site) {
    Leaf& leaf = leaves_[leaf_of(site)];
    const auto at = static_cast<std::size_t>(std::ranges::find(leaf.sites, site) - leaf.sites.begin());
    leaf.sites[at] = leaf.sites.back();
    leaf.near[at] = leaf.near.back();
    leaf.known[at] = leaf.known.back();
    leaf.sites.pop_back();
    leaf.near.pop_back();
    leaf.known.pop_back();
    --candidates_;
}

void FarGrowth::pull_near(std::uint32_t site, float size) {
    each_near(site, [&](std::size_t number) {
        Leaf& leaf = leaves_[number];
        leaf.lowest = none_yet;
        for (std::size_t i = 0; i < leaf.sites.size(); ++i) {
            const std::int64_t term =
                inverse_distance(leaf.sites[i], site, static_cast<std::uint32_t>(front_.columns()), size);
            leaf.near[i] += term;
            leaf.known[i] += term;
            leaf.lowest = std::min(leaf.lowest, leaf.known[i]);
        }
    });
}

// A free site beside a charge becomes a candidate.
void FarGrowth::offer(std::uint32_t site) {
    if (sites_[site] != Front::free) return;
    sites_[site] = 0;
    ++candidates_;
    std::int64_t near = 0;
    const FarCharge place = charge_at(site, 1.0f);
    each_near(site, [&](std::size_t number) {
        for (const FarCharge& charge : leaves_[number].charges) {
            const std::int32_t x = place.x - charge.x, y = place.y - charge.y;
            near += inverse_parts_at(static_cast<float>(x * x + y * y), charge.size);
        }
    });
    Leaf& leaf = leaves_[leaf_of(site)];
    leaf.sites.push_back(site);
    leaf.near.push_back(near);
    leaf.known.push_back(near + far_sum(site));
    leaf.lowest = std::min(leaf.lowest, leaf.known.back());
    lowest_ = std::min(lowest_, leaf.known.back());
}

void FarGrowth::renew() {
    std::int64_t highest = 0;
    lowest_ = none_yet;
    for (Leaf& leaf : leaves_) {
        leaf.lowest = none_yet;
        for (std::size_t i = 0; i < leaf.sites.size(); ++i) {
            leaf.known[i] = leaf.near[i] + far_sum(leaf.sites[i]);
            leaf.lowest = std::min(leaf.lowest, leaf.known[i]);
            highest = std::max(highest, leaf.known[i]);
        }
        lowest_ = std::min(lowest_, leaf.lowest);
    }
    const std::int64_t range = candidates_ == 0 ? 0 : highest - lowest_;
    grain_ = std::max(0, static_cast<int>(std::bit_width(static_cast<std::uint64_t>(range))) - 7);
}

std::uint64_t FarGrowth::bound(const Bounds& bounds, const Leaf& leaf) const {
    const std::int64_t sum = std::clamp(surely(leaf.lowest), bounds.lower, bounds.upper);
    const std::uint64_t weight = bounds.weight(-sum);
    return weight + (weight >> 11) + 1;  // more than what floats may round a weight up by
}

FarGrowth::Bounds FarGrowth::bounds(std::int64_t highest, float eta) const {
    const std::int64_t upper = ((highest >> grain_) + 1) << grain_;
    const std::int64_t lower = (surely(lowest_) >> grain_) << grain_;
    Bounds made{lower, upper, Weights(-upper, -lower, std::floor(eta * 16.0f) * 0.0625f), {}};
    const FarGrid& grid = field_.grid();
    made.totals.resize(grid.blocks());
    for (std::size_t i = 0; i < leaves_.size(); ++i) {
        if (!leaves_[i].sites.empty()) made.totals[i] = leaves_[i].sites.size() * bound(made, leaves_[i]);
    }
    for (std::size_t level = 1; level < grid.levels.size(); ++level) {
        const FarLevel &cut = grid.levels[level], &finer = grid.levels[level - 1];
        for (std::size_t i = 0; i < finer.columns * finer.rows; ++i) {
            const std::size_t x = i % finer.columns / 2, y = i / finer.columns / 2;
            made.totals[cut.first + y * cut.columns + x] += made.totals[finer.first + i];
        }
    }
    return made;
}

// The leaf on which a draw falls, and what is left of the draw in it: in each block row by row of the four within.
std::size_t FarGrowth::descend(const Bounds& bounds, std::uint64_t& drawn) const {
    std::size_t x = 0, y = 0, found = 0;
    for (std::size_t level = field_.grid().levels.size(); level-- > 0;) {
        const FarLevel& cut = field_.grid().levels[level];
        for (std::size_t part = 0; part < 4; ++part) {
            const std::size_t column = 2 * x + part % 2, row = 2 * y + part / 2;
            if (column >= cut.columns || row >= cut.rows) continue;
            found = cut.first + row * cut.columns + column;
            if (drawn < bounds.totals[found]) break;
            drawn -= bounds.totals[found];
        }
        x = (found - cut.first) % cut.columns;
        y = (found - cut.first) / cut.columns;
    }
    return found;
}

std::optional<std::uint32_t> FarGrowth::choose(const Particle& particle) const {
    if (candidates_ == 0) return std::nullopt;
    const std::vector<std::int64_t> sums = this->sums();
    const std::int64_t highest = *std::ranges::max_element(sums);
    const Bounds bounds = this->bounds(highest, particle.eta);
    const Weights weight = Weights(-bounds.upper, -bounds.lower, particle.eta).from(-highest);
    const FarLevel& top = field_.grid().levels.back();
    std::uint64_t total = 0;
    for (std::size_t i = top.first; i < bounds.totals.size(); ++i) total += bounds.totals[i];
    const std::uint64_t attempts = far_attempts(candidates_);
    for (std::uint64_t attempt = 0; attempt < attempts; ++attempt) {
        std::uint64_t drawn = upper_product(further_draw(particle, attempt), total);
        const Leaf& leaf = leaves_[descend(bounds, drawn)];
        const std::uint64_t each = bound(bounds, leaf);
        const std::size_t i = drawn / each;
        const std::int64_t sum = leaf.near[i] + far_sum(leaf.sites[i]);
        if (drawn % each < weight(-std::max(sum, bounds.lower))) return leaf.sites[i];
    }
    return choose_of_all(particle, further_draw(particle, attempts));
}

// Where draws have been rejected too often: as Growth chooses, leaf by leaf.
std::uint32_t FarGrowth::choose_of_all(const Particle& particle, std::uint64_t draw) const {
    std::vector<std::uint32_t> sites;
    std::vector<std::int64_t> values;
    for (const Leaf& leaf : leaves_) {
        for (std::size_t i = 0; i < leaf.sites.size(); ++i) {
            sites.push_back(leaf.sites[i]);
            values.push_back(-(leaf.near[i] + far_sum(leaf.sites[i])));
        }
    }
    const auto [lowest, highest] = std::ranges::minmax(values);
    const Weights weight(lowest, highest, particle.eta);
    std::uint64_t total = 0;
    for (const std::int64_t value : values) total += weight(value);
    const std::uint64_t drawn = upper_product(draw, total);
    std::uint64_t passed = 0;
    std::size_t i = 0;
    while ((passed += weight(values[i])) <= drawn) ++i;
    return sites[i];
}

std::vector<std::int64_t> FarGrowth::sums() const {
    std::vector<std::int64_t> sums(front_.places().size(), 0);
    for (const Leaf& leaf : leaves_) {
        for (std::size_t i = 0; i < leaf.sites.size(); ++i) {
            const auto place = static_cast<std::size_t>(front_.sites()[leaf.sites[i]]);
            sums[place] = leaf.near[i] + far_sum(leaf.sites[i]);
        }
    }
    return sums;
}

}  // namespace pelage::reference
