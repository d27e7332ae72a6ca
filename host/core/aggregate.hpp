// Laplacian growth (fast dielectric breakdown: Kim, Sewall, Sud & Lin 2007; McConnell 2024): what is the same for every
// backend.
//
// Charges lie on sites of a lattice. A candidate is a free site with a charge on one of the eight sites around it. In
// each iteration a candidate becomes a charge, drawn with a weight of its potential, which the charges add up to.
#pragma once

#include "core/experiment.hpp"
#include "core/front.hpp"
#include "core/snapshot.hpp"

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace pelage {

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

bool has_charges(const Experiment&);

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
    float size = 1.0f;
    // What draws are counted by.
    std::uint64_t iteration = 0;
    std::size_t rule = 0;
    std::int64_t seed = 0;
};

// A further draw for the same particle, in parts of 2^64; the draw 0 is the particle's own.
std::uint64_t further_draw(const Particle&, std::uint64_t number);

// Throws Error where a parameter has a value that means nothing. The snapshot gives size and centre.
Particle particle_at(const Experiment&, std::size_t rule, std::uint64_t iteration, const Snapshot&);

// All particles of the iterations from `first` on, `count` of them, one a rule that is active.
struct Arrival {
    std::uint64_t iteration = 0;
    Particle particle;
};
std::vector<Arrival> arrivals(const Experiment&, std::uint64_t first, std::uint64_t count, const Snapshot&);

// Of each site, whether charges may lie there: 0 where `create charges ... where` is false. Empty: everywhere.
std::vector<double> open_sites(const Experiment&, const Snapshot&);

// The charges of a snapshot and their candidates. Throws Error as Front does, and where a charge lies on a site that is
// not open.
Front front_of(const Experiment&, const Snapshot&);

// Sum of size / r from a site to all charges, in parts.
std::int64_t sum_at(std::uint32_t site, const Front&);

// The state of an aggregate as a snapshot shows it: the order of arrival of each charge, its seed and its size, and of
// each candidate sum (1 - size / r) over all charges. `sums` are those of size / r, one a place, in parts.
void show_aggregate(Snapshot&, const Aggregate&, const Front&, const std::vector<std::int64_t>& sums);

// The sums that a snapshot tells; none where they do not hold: there are none at the start, and numbers that were
// rounded to float are not exact any more.
std::vector<std::int64_t> told_sums(const Snapshot&, const Aggregate&, const Front&);

}  // namespace pelage
