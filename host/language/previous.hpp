// The chemicals that previous() adds to an experiment.
#pragma once

#include "core/experiment.hpp"

namespace pelage::language {

// Keeps what another chemical was an iteration ago; it is called "previous(U)", as no line can name a chemical.
inline bool keeps_previous(const Chemical& chemical) { return chemical.name.ends_with(')'); }

}  // namespace pelage::language
