// What is wrong with how an experiment starts: rates below 0, concentrations outside a chemical's bounds.
#pragma once

#include "core/experiment.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace pelage {

struct StartFault {
    std::optional<std::size_t> statement;  // place in Experiment::prepattern
    std::optional<std::size_t> picture;    // chemical whose Chemical::initial it is
    bool rate = false;                     // of the statement's values the diffusion rate, else the concentration
    bool untold = false;                   // nobody has said a concentration, and 0 will not do
    bool refused = true;                   // else it is odd, but published experiments do so
    std::string text;
};

// In order of statements, then pictures. Refused are a draw of a rate that may fall below 0, a rate below 0 on a
// lattice, a concentration outside [floor, limit] of the first phase. A rate below 0 that is not drawn (free cells may
// pump) and a draw that lies partly outside the bounds are odd.
std::vector<StartFault> start_faults(const Experiment&);

}  // namespace pelage
