// The explicit Euler limit of diffusion, checked before a run.
#pragma once

#include "core/experiment.hpp"
#include "core/snapshot.hpp"
#include "core/space.hpp"

#include <optional>
#include <string>

namespace pelage {

struct Instability {
    std::string phase;  // empty when the experiment has only one
    std::string chemical;
    double rate = 0.0;     // the largest of any cell
    double network = 0.0;  // what networks add to it
    std::size_t line = 0;  // of the rule of that network; 0 where there is none
    double time_step = 0.0;
    double largest_time_step = 0.0;  // that holds: 2 / ((rate + network) * largest eigenvalue of the stencil)

    std::string rates() const;  // "a rate of 5 and 0.5 by a network": for messages
};

// Largest eigenvalue of minus the stencil on an endless lattice.
double stiffness(Stencil);  // of one that has a name
// Of any lattice's: twice the inverse of the largest rate times time step under which no wave grows; infinity where
// each makes some wave grow.
double stiffness(const Lattice&);

// The first phase and chemical whose positive rates break the limit; empty: stable. Rates that rules change during the
// run cannot be foreseen and are not judged, nor is the diffusion of a network that has a condition or is no number.
std::optional<Instability> find_instability(const Experiment&, const Snapshot& initial);

}  // namespace pelage
