// An aggregate that grows particle by particle: the plain loop.
#pragma once

#include "core/aggregate.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace pelage::reference {

class Growth {
public:
    Growth() = default;
    // With no `sums` they are added up anew.
    explicit Growth(Front front, std::vector<std::int64_t> sums = {});

    // The site that the draw falls on; nothing where no candidate is left.
    std::optional<std::uint32_t> choose(const Particle&);
    // A free site becomes a charge.
    void take(std::uint32_t site, float size = 1.0f);

    const Front& front() const { return front_; }
    const std::vector<std::int64_t>& sums() const { return sums_; }         // of size / r, one a place, in parts
    const std::vector<std::uint64_t>& weights() const { return weights_; }  // of the last choice, one a place

private:
    std::int64_t pull(const Particle&, std::uint32_t site) const;

    Front front_;
    std::vector<std::int64_t> sums_;
    std::vector<std::int64_t> values_;  // potential in units of the radius, less what is the same for all, in parts
    std::vector<std::uint64_t> weights_;
};

}  // namespace pelage::reference
