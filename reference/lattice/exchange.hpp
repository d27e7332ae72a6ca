// Diffusion on a lattice or in a volume, from neighbour to neighbour, and the gradient that polarity follows.
#pragma once

#include "core/adjacency.hpp"
#include "core/space.hpp"
#include "reference/rules/state.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace pelage::reference {

struct Medium {  // what diffusion runs through
    Lattice lattice;
    LatticeAdjacency adjacency;
    std::optional<Volume> volume = std::nullopt;  // in place of the lattice
};

// See Ground.
template <class T>
std::vector<T> laplacian_of(const Medium&, const std::vector<T>& values);
template <class T>
std::vector<T> gradient_of(const Medium&, Axis, const std::vector<T>& values);
template <class T>
std::vector<T> stencil_of(const Medium&, const NamedStencil&, const std::vector<T>& values);

// next += what `chemical` exchanges in one iteration, where rates are the same in all cells.
template <class T>
void diffuse_uniform(const Medium&, std::size_t chemical, T dt, const State<T>& old, State<T>& next);

// The same where each cell has its own rate; anisotropic: a cell with a polarity p multiplies its rate by
// |d . p| / |d|, d being the vector to the other cell.
template <class T>
void diffuse_per_cell(const Medium&, std::size_t chemical, bool anisotropic, T dt, const State<T>& old, State<T>& next);

// next.polarity := the unit gradient of chemical requests[cell] in `old`, where that is not -1 and steep enough.
template <class T>
void follow_gradients(const Medium&, const std::vector<std::int32_t>& requests, const State<T>& old, State<T>& next);

}  // namespace pelage::reference
