// How a chemical's diffusion rate may differ from cell to cell, and so which formula it needs.
#pragma once

#include "core/experiment.hpp"

#include <cstddef>
#include <vector>

namespace pelage {

enum class RateKind {
    none,     // 0 everywhere and for good: the chemical does not diffuse
    uniform,  // the same in all cells at any one time
    per_cell  // differs between cells, or a rule may make it differ, or direction matters (anisotropic, on a lattice)
};

// Judged from the rules, the phases and the cells' rates as they are.
RateKind rate_kind(const Experiment&, const std::vector<double>& rates, std::size_t chemical);

}  // namespace pelage
