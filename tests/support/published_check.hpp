// Holds a run of free cells against the states that the published program wrote out.
#pragma once

#include "core/tissue.hpp"
#include "support/published_cells.hpp"

#include <memory>
#include <string>

namespace test {

// On the reference in float, with the search that the published program chose: its spatial sorting for a packed
// domain, else the exact one.
std::unique_ptr<pelage::Tissue> start_published(const pelage::Experiment&);

// Advances to "10", "200", ..., "final" and compares all that the state holds: concentrations within
// max(4e-6 of the range, 1e-5 at the end, 4 times the program's own noise), positions alike, neighbour counts exactly.
// The factor 4 stands for another order of the neighbours in each sum. Returns what is wrong, in words; empty: nothing.
std::string published_mismatch(const PublishedCells&, pelage::Tissue&, const std::string& state);

}  // namespace test
