// Laplacian growth (fast dielectric breakdown: Kim, Sewall, Sud & Lin 2007; McConnell 2024): what is the same for every
// backend.
//
// Charges lie on sites of a lattice. A candidate is a free site with a charge on one of the eight sites around it. In
// each iteration a candidate becomes a charge, drawn with a weight of its potential, which the charges add up to.
#pragma once

#include "core/experiment.hpp"
#include "core/snapshot.hpp"

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace pelage {

inline constexpr std::size_t widest_aggregate = 32768;  // squares of distances are counted in 31 bits
inline constexpr std::uint32_t no_site = 0xffffffffu;

// A distance's inverse is counted in these parts of one, so that sums have the same bits in any order.
inline constexpr double inverse_parts = 0x1p30;

// Calls visit(operand) for what an `aggregate` reads.
template <class Visit>
void each_parameter(const Aggregate& aggregate, Visit&& visit) {
    for (const Operand* operand :
         {&aggregate.eta, &aggregate.radius, &aggregate.x, &aggregate.y, &aggregate.strength}) {
        visit(*operand);
    }
}

// The experiment's first `aggregate`. Throws Error where there is none.
const Aggregate& aggregate_of(const Experiment&);

// What a rule asks for in one iteration.
struct Particle {
    float eta = 1.0f;
    // A candidate at the distance d of the site (x, y), in sites and no less than 1, has pull / d more potential, in
    // units of the radius.
    float pull = 0.0f;
    float x = 0.0f;
    float y = 0.0f;
    std::uint64_t draw = 0;  // in parts of 2^64
};

// Throws Error where a parameter has a value that means nothing. The snapshot gives size and centre.
Particle particle_at(const Experiment&, std::size_t rule, std::uint64_t iteration, const Snapshot&);

// All particles of the iterations from `first` on, `count` of them, one a rule that is active.
struct Arrival {
    std::uint64_t iteration = 0;
    Particle particle;
};
std::vector<Arrival> arrivals(const Experiment&, std::uint64_t first, std::uint64_t count, const Snapshot&);

// Charges in order of arrival, and candidates in places. A candidate that becomes a charge leaves its place to the next
// new one (the place that was left last comes first); where no place is left, there is a new one at the end.
class Front {
public:
    Front() = default;
    // Throws Error when no site holds a charge or the lattice is too large; `source` names the experiment there.
    Front(const Snapshot&, std::size_t order, std::string_view source = "an aggregate");

    // A free site becomes a charge. What it makes candidates of stands in added(): columns from the left to the right,
    // each from the lower to the upper row.
    void take(std::uint32_t site);

    std::size_t columns() const { return columns_; }
    std::size_t rows() const { return rows_; }
    const std::vector<std::uint32_t>& charges() const { return charges_; }
    const std::vector<std::uint32_t>& places() const { return places_; }  // the site, or no_site
    const std::vector<std::uint32_t>& left() const { return left_; }      // places, the last one first
    const std::vector<std::uint32_t>& added() const { return added_; }    // places

    // Of each site: free, taken, or the place of a candidate.
    static constexpr std::int32_t free = -1;
    static constexpr std::int32_t taken = -2;
    const std::vector<std::int32_t>& sites() const { return sites_; }

private:
    void add(std::uint32_t site);

    std::size_t columns_ = 0;
    std::size_t rows_ = 0;
    std::vector<std::uint32_t> charges_;
    std::vector<std::uint32_t> places_;
    std::vector<std::uint32_t> left_;
    std::vector<std::uint32_t> added_;
    std::vector<std::int32_t> sites_;
};

// Sum of 1 / r from a site to all charges, in parts.
std::int64_t sum_at(std::uint32_t site, const Front&);

// The state of an aggregate as a snapshot shows it: the order of arrival of each charge, and of each candidate
// sum (1 - 1 / r) over all charges. `sums` are those of 1 / r, one a place, in parts.
void show_aggregate(Snapshot&, const Aggregate&, const Front&, const std::vector<std::int64_t>& sums);

// The sums that a snapshot tells; none where they do not hold: there are none at the start, and numbers that were
// rounded to float are not exact any more.
std::vector<std::int64_t> told_sums(const Snapshot&, const Aggregate&, const Front&);

}  // namespace pelage
