// See charges_piece.hpp.
#include "verify/charges_piece.hpp"

#include "core/aggregate.hpp"

#include <algorithm>
#include <cstddef>
#include <variant>
#include <vector>

namespace pelage::verify {

namespace {

void open_all(Experiment& experiment) {
    for (Statement& statement : experiment.prepattern) {
        if (auto* made = std::get_if<CreateMatrix>(&statement)) made->where.reset();
    }
}

// The middle, or the first open site behind it, going on from the first one.
std::size_t seed_site(const std::vector<double>& open, std::size_t cells) {
    std::size_t site = cells / 2;
    while (!open.empty() && open[site] == 0.0) site = (site + 1) % cells;
    return site;
}

}  // namespace

void give_charges(Experiment& experiment, Snapshot& piece) {
    std::vector<double> open = open_sites(experiment, piece);
    if (!open.empty() && std::ranges::count(open, 0.0) == std::ranges::ssize(open)) {
        open_all(experiment);
        open.clear();
    }
    const Aggregate& aggregate = aggregate_of(experiment);
    std::vector<double>& order = piece.conc[aggregate.order];
    for (std::size_t site = 0; site < open.size(); ++site) {
        if (open[site] == 0.0) order[site] = 0.0;
    }
    if (std::ranges::none_of(order, [](double arrived) { return arrived > 0.0; }))
        order[seed_site(open, order.size())] = 1.0;
    std::ranges::fill(piece.conc[aggregate.potential], 0.0);
}

}  // namespace pelage::verify
