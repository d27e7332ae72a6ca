// VisualPDE's presets: JSON, or an address that holds it compressed. Facts are those of VisualPDE's documentation of
// all its options, and of the names of its fields.
#pragma once

#include "import/draft.hpp"
#include "import/problems.hpp"

#include <string>

namespace pelage::imports {

// Throws Error for what is no such preset.
Draft read_visualpde(std::string text, const std::string& name, Problems&);

}  // namespace pelage::imports
