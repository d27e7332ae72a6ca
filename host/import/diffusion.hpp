// Tells diffusion at a constant rate from the rest of a chemical's change.
#pragma once

#include "import/draft.hpp"
#include "import/term.hpp"

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace pelage::imports {

// The parts of a sum, each with its sign.
std::vector<std::pair<TermRef, bool>> summands(const TermRef&);

// Takes each `RATE * laplacian(C)` of the chemical C out of its change, and adds the rates to the chemical's, where the
// rates are made of names that are `constant` and their sum is not below 0.
void take_diffusion(TermRef& change, DraftChemical&, const std::function<bool(const std::string&)>& constant,
                    const std::function<double(const std::string&)>& value);

}  // namespace pelage::imports
