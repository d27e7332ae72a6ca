// The built-in reactions written as formulas: what a formula costs beside a word.
#pragma once

#include "bench/cases.hpp"

#include <vector>

namespace pelage::bench {

// The twin of each is the same experiment with the reaction's word.
std::vector<Case> formula_cases();

}  // namespace pelage::bench
