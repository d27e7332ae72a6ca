// What VisualPDE's boundary conditions become: the lattice's edge, and rules for the cells along it.
#pragma once

#include "import/visualpde_meaning.hpp"

#include <array>
#include <string>
#include <vector>

namespace pelage::imports {

struct PdeSide {
    enum class Kind { periodic, fixed, flux } kind = Kind::periodic;
    TermRef value = number_term(0.0);  // of the species (fixed), or its slope outward (flux)
};

using PdeEdges = std::array<PdeSide, 4>;  // left, right, bottom, top

PdeEdges read_edges(const PdePreset&, PdeMeaning&, std::size_t species, Problems&);

// The cells of the sides that the test takes; null: of none.
TermRef cells_along(const PdeEdges&, bool one_dimensional, PdeSide::Kind);

// The edge of the whole lattice, of those species whose edge counts; what it cannot do for single species is noted.
std::string edge_of_lattice(const std::vector<PdeEdges>&, const std::vector<bool>& counts,
                            const std::vector<std::string>& species, bool one_dimensional, const PdePreset&, Problems&);

// What flows in over the edge in a unit of time, where the rate of diffusion is given.
TermRef inflow(const PdeEdges&, bool one_dimensional, const TermRef& rate, const TermRef& dx);

}  // namespace pelage::imports
