// Derivatives of terms, for diffusion at a rate that depends on chemicals or on the place.
#pragma once

#include "import/term.hpp"

#include <optional>
#include <string>

namespace pelage::imports {

// By a name. Empty for functions whose derivative is not known here, and for slopes of that name.
std::optional<TermRef> derivative(const TermRef&, const std::string& name);

}  // namespace pelage::imports
