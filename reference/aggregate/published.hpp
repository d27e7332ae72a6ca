// Growth in the arithmetic of McConnell's published program (2024): potentials as sums of floats, which drift as they
// grow. It follows that program site by site when it is given its draws; what Pelage grows for users is exact.
#pragma once

#include "core/aggregate.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace pelage::reference {

// The sum of the terms by halves, as the program's golden data was made: chunks of 8192 terms in turn, each by halves
// down to blocks of up to 128 in eight partial sums.
float sum_by_halves(std::span<const float> terms);

class PublishedGrowth {
public:
    PublishedGrowth(Front front, float radius);

    // The first candidate at which the sum of the weights ((phi - min) / (max - min))^eta reaches draw * (sum of all);
    // the first of all where all potentials are equal, since every weight is NaN there. Nothing where none is left.
    std::optional<std::uint32_t> choose(float eta, float draw) const;
    // A free site becomes a charge.
    void take(std::uint32_t site);

    const Front& front() const { return front_; }
    const std::vector<float>& potentials() const { return potentials_; }  // one a place

private:
    float term(std::uint32_t site, std::uint32_t charge) const;
    float sum_at(std::uint32_t site) const;

    Front front_;
    float radius_;
    std::vector<float> potentials_;
};

}  // namespace pelage::reference
