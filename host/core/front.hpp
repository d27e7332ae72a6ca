// The charges of an aggregate and the free sites beside them, as they follow from the order of arrival alone.
#pragma once

#include "core/snapshot.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace pelage {

inline constexpr std::size_t widest_aggregate = 32768;  // squares of distances are counted in 31 bits
inline constexpr std::uint32_t no_site = 0xffffffffu;

// Charges in order of arrival, and candidates in places. A candidate that becomes a charge leaves its place to the next
// new one (the place that was left last comes first); where no place is left, there is a new one at the end.
class Front {
public:
    Front() = default;
    // Throws Error when no site holds a charge or the lattice is too large; `source` names the experiment there.
    // On sites where `open` is 0 nothing grows; empty: it does everywhere. The chemical `seed` tells of charges which
    // seed they descend from, where it is not 0.
    Front(const Snapshot&, std::size_t order, std::string_view source = "an aggregate",
          const std::vector<double>& open = {}, std::optional<std::size_t> seed = std::nullopt);

    // Tells how large the charges are, one number for each; without that, they are all 1.
    void set_sizes(std::vector<float> sizes) { sizes_ = std::move(sizes); }

    // A free site becomes a charge, of the seed of that charge which made it a candidate. What it makes candidates of
    // stands in added(): columns from the left to the right, each from the lower to the upper row.
    void take(std::uint32_t site, float size = 1.0f);

    std::size_t columns() const { return columns_; }
    std::size_t rows() const { return rows_; }
    const std::vector<std::uint32_t>& charges() const { return charges_; }
    // Of each charge. That of a seed without a number is its place in the order of arrival.
    const std::vector<double>& seeds() const { return seeds_; }
    const std::vector<float>& sizes() const { return sizes_; }
    const std::vector<std::uint32_t>& places() const { return places_; }  // the site, or no_site
    const std::vector<std::uint32_t>& left() const { return left_; }      // places, the last one first
    const std::vector<std::uint32_t>& added() const { return added_; }    // places

    // Of each site: free, taken, closed, or the place of a candidate.
    static constexpr std::int32_t free = -1;
    static constexpr std::int32_t taken = -2;
    static constexpr std::int32_t closed = -3;
    const std::vector<std::int32_t>& sites() const { return sites_; }

private:
    void take_of(double seed, std::uint32_t site, float size);
    void add(std::uint32_t site);

    std::size_t columns_ = 0;
    std::size_t rows_ = 0;
    std::vector<std::uint32_t> charges_;
    std::vector<double> seeds_;  // of charges
    std::vector<float> sizes_;   // of charges
    std::vector<std::uint32_t> places_;
    std::vector<double> parents_;  // of candidates: the seeds that they would descend from
    std::vector<std::uint32_t> left_;
    std::vector<std::uint32_t> added_;
    std::vector<std::int32_t> sites_;
};

}  // namespace pelage
