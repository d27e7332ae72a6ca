// See growth.hpp.
#include "reference/aggregate/growth.hpp"

#include "core/inverse_root.hpp"
#include "reference/aggregate/weight.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pelage::reference {

Growth::Growth(Front front, std::vector<std::int64_t> sums) : front_(std::move(front)), sums_(std::move(sums)) {
    if (!sums_.empty()) return;
    for (const std::uint32_t site : front_.places()) sums_.push_back(site == no_site ? 0 : sum_at(site, front_));
}

std::int64_t Growth::pull(const Particle& particle, std::uint32_t site) const {
    const auto columns = static_cast<std::uint32_t>(front_.columns());
    const float x = static_cast<float>(site % columns) - particle.x;
    const float y = static_cast<float>(site / columns) - particle.y;
    const float square = x * x + y * y;
    const float distance = inverse_root(square < 1.0f ? 1.0f : square);
    return static_cast<std::int64_t>(particle.pull * distance * 0x1p30f);
}

std::optional<std::uint32_t> Growth::choose(const Particle& particle) {
    if (front_.left().size() == front_.places().size()) return std::nullopt;
    const std::vector<std::uint32_t>& places = front_.places();
    std::int64_t lowest = std::numeric_limits<std::int64_t>::max();
    std::int64_t highest = std::numeric_limits<std::int64_t>::min();
    values_.resize(places.size());
    for (std::size_t place = 0; place < places.size(); ++place) {
        if (places[place] == no_site) continue;
        values_[place] = (particle.pull == 0.0f ? 0 : pull(particle, places[place])) - sums_[place];
        lowest = std::min(lowest, values_[place]);
        highest = std::max(highest, values_[place]);
    }
    const Weights weight(lowest, highest, particle.eta);
    std::uint64_t total = 0;
    weights_.resize(places.size());
    for (std::size_t place = 0; place < places.size(); ++place) {
        weights_[place] = places[place] == no_site ? 0 : weight(values_[place]);
        total += weights_[place];
    }
    const std::uint64_t drawn = upper_product(particle.draw, total);
    std::uint64_t passed = 0;
    std::size_t place = 0;
    while ((passed += weights_[place]) <= drawn) ++place;
    return places[place];
}

void Growth::take(std::uint32_t site, float size) {
    const auto columns = static_cast<std::uint32_t>(front_.columns());
    front_.take(site, size);
    sums_.resize(front_.places().size());
    for (std::size_t place = 0; place < sums_.size(); ++place) {
        if (front_.places()[place] != no_site)
            sums_[place] += inverse_distance(front_.places()[place], site, columns, size);
    }
    for (const std::uint32_t place : front_.added()) sums_[place] = sum_at(front_.places()[place], front_);
}

}  // namespace pelage::reference
