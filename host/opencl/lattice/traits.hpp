// What one set of active rules asks of a lattice's chemicals, and the parts of its kernels that follow from that alone.
#pragma once

#include "core/experiment.hpp"
#include "core/lattice.hpp"
#include "core/tissue.hpp"
#include "opencl/rules/emit_rules.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace pelage {

class LatticeTraits {
public:
    LatticeTraits(const Experiment&, const LatticePlan&, const RuleUse&);

    bool per_cell(std::size_t i) const { return plan_.rates[i] == RateKind::per_cell; }
    bool directed(std::size_t i) const;  // its rate feels the polarity
    bool rolled(std::size_t i) const;    // diffuses by sums of rows, see kernels/lattice/stencil.cl
    bool visited(std::size_t i) const {
        return plan_.rates[i] != RateKind::none && !rolled(i);
    }                                                                          // neighbour by neighbour
    bool followed(std::size_t i) const { return use_.polarizes.contains(i); }  // by the polarity
    // Rules read how it changes from cell to cell.
    bool looked_around(std::size_t i) const {
        return use_.laplacians.contains(i) || use_.gradients.contains(i) || use_.surrounds.contains(i);
    }
    // Its neighbours are read one by one, for whatever reason.
    bool watched(std::size_t i) const { return visited(i) || followed(i) || looked_around(i); }
    // Only its bounds ever act on it: it is written in the last step of a launch alone.
    bool idle(std::size_t i) const;
    bool maps(std::size_t mapping) const;  // it is read or written
    bool writes_rates() const { return !use_.rates_written.empty(); }
    bool turns() const { return !use_.polarizes.empty(); }
    bool polarity() const;  // read, or written
    bool visits() const;    // some neighbours are looked at one by one

    // Before the rules: declares what they read of neighbours, and sums it up; empty where they read nothing.
    std::string look() const;
    // The loop over a cell's neighbours, with what is done for each.
    std::string around(const std::string& each) const;
    // What is done for each neighbour. `means`: rates between neighbours are known (kernels/lattice/means.cl).
    std::string visit(bool means = false) const;
    // Declares turned_x and turned_y: the polarity becomes the unit gradient where that is steep enough.
    std::string turn(Precision) const;
    // Defines for kernels/lattice/exchange.cl.
    std::string shares(Precision) const;

private:
    const Experiment& experiment_;
    const LatticePlan& plan_;
    const RuleUse& use_;
};

}  // namespace pelage
