// See published.hpp.
#include "reference/aggregate/published.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace pelage::reference {

namespace {

constexpr std::size_t lanes = 8, block = 128, chunk = 8192;

float sum_of_block(std::span<const float> terms) {
    std::size_t i = 0;
    float sum = 0.0f;
    if (terms.size() >= lanes) {
        std::array<float, lanes> r{};
        std::copy_n(terms.begin(), lanes, r.begin());
        for (i = lanes; i + lanes <= terms.size(); i += lanes)
            for (std::size_t k = 0; k < lanes; ++k) r[k] += terms[i + k];
        sum = ((r[0] + r[1]) + (r[2] + r[3])) + ((r[4] + r[5]) + (r[6] + r[7]));
    }
    for (; i < terms.size(); ++i) sum += terms[i];
    return sum;
}

float sum_of_chunk(std::span<const float> terms) {
    if (terms.size() <= block) return sum_of_block(terms);
    const std::size_t half = terms.size() / 2 / lanes * lanes;
    return sum_of_chunk(terms.first(half)) + sum_of_chunk(terms.subspan(half));
}

}  // namespace

float sum_by_halves(std::span<const float> terms) {
    float sum = 0.0f;
    for (; !terms.empty(); terms = terms.subspan(std::min(chunk, terms.size())))
        sum += sum_of_chunk(terms.first(std::min(chunk, terms.size())));
    return sum;
}

PublishedGrowth::PublishedGrowth(Front front, float radius) : front_(std::move(front)), radius_(radius) {
    for (const std::uint32_t site : front_.places()) potentials_.push_back(site == no_site ? 0.0f : sum_at(site));
}

float PublishedGrowth::term(std::uint32_t site, std::uint32_t charge) const {
    const auto columns = static_cast<std::uint32_t>(front_.columns());
    const float x = static_cast<float>(site % columns) - static_cast<float>(charge % columns);
    const float y = static_cast<float>(site / columns) - static_cast<float>(charge / columns);
    return 1.0f - radius_ / std::sqrt(x * x + y * y);
}

float PublishedGrowth::sum_at(std::uint32_t site) const {
    std::vector<float> terms;
    for (const std::uint32_t charge : front_.charges()) terms.push_back(term(site, charge));
    return sum_by_halves(terms);
}

std::optional<std::uint32_t> PublishedGrowth::choose(float eta, float draw) const {
    const std::vector<std::uint32_t>& places = front_.places();
    std::vector<std::uint32_t> sites;
    std::vector<float> potentials;
    for (std::size_t place = 0; place < places.size(); ++place) {
        if (places[place] == no_site) continue;
        sites.push_back(places[place]);
        potentials.push_back(potentials_[place]);
    }
    if (sites.empty()) return std::nullopt;
    const auto [lowest, highest] = std::ranges::minmax(potentials);
    if (lowest == highest) return sites.front();
    double total = 0.0;
    std::vector<double> sums;
    for (const float potential : potentials) {
        const float weight = std::pow((potential - lowest) / (highest - lowest), eta);
        sums.push_back(total += static_cast<double>(weight));
    }
    const auto found = std::ranges::lower_bound(sums, static_cast<double>(draw) * total);
    return sites[static_cast<std::size_t>(found - sums.begin())];
}

void PublishedGrowth::take(std::uint32_t site) {
    front_.take(site);
    potentials_.resize(front_.places().size());
    for (std::size_t place = 0; place < potentials_.size(); ++place) {
        if (front_.places()[place] != no_site) potentials_[place] += term(front_.places()[place], site);
    }
    for (const std::uint32_t place : front_.added()) potentials_[place] = sum_at(front_.places()[place]);
}

}  // namespace pelage::reference
