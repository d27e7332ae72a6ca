// What both backends must agree on before they step a lattice: shape, stencil, and which formula a chemical needs.
#pragma once

#include "core/experiment.hpp"
#include "core/snapshot.hpp"

#include <cstddef>
#include <vector>

namespace pelage {

// published: the order of operations of Malheiros & Walter's program, without fma, for a sqr_grid: each rule
//   new += s * f * dt, then each neighbour in turn new += rate * (theirs - mine) * dt.
// fused: ours, for a matrix: new = fma(s * dt, f, new), then one fma with the whole stencil sum.
enum class Arithmetic { published, fused };

enum class RateKind {
    none,     // 0 everywhere and for good: the chemical does not diffuse
    uniform,  // the same in all cells at any one time
    per_cell  // differs between cells, or a rule may make it differ, or direction matters (anisotropic)
};

struct LatticePlan {
    std::size_t columns = 0;
    std::size_t rows = 0;
    Boundary boundary = Boundary::no_flux;
    Stencil stencil = Stencil::nine_point;
    Arithmetic arithmetic = Arithmetic::fused;
    std::vector<RateKind> rates;  // one a chemical
    bool polarity = false;        // any rule or chemical reads or writes polarity
};

// Throws Error when the experiment is not a lattice.
LatticePlan lattice_plan(const Experiment&, const Snapshot& initial);

}  // namespace pelage
