// Expressions outside rules: of fields, which depend on the place alone, of how a tissue starts, and of pictures.
#pragma once

#include "core/adjacency.hpp"
#include "core/expression.hpp"
#include "core/snapshot.hpp"
#include "core/space.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pelage {

// What such an expression reads, one entry a cell.
struct Scene {
    std::size_t columns = 0;  // 0 for free cells
    std::size_t rows = 0;
    std::size_t layers = 0;  // of a volume
    std::size_t first = 0;   // id of the first cell that is looked at
    std::vector<double> x, y;
    std::vector<double> z;  // of a mesh; empty: none of it
    // What may be read; null: none of it.
    const std::vector<std::vector<double>>* fields = nullptr;  // [field][cell], of those that are looked at
    const std::vector<std::vector<double>>* conc = nullptr;    // [chemical][id]
    const std::vector<std::vector<double>>* diff = nullptr;
    const Snapshot* state = nullptr;       // mappings, births, neighbours
    double time = 0.0;                     // of the state
    const Lattice* lattice = nullptr;      // with columns and rows of the scene: laplacian and gradients of `conc`
    const Volume* volume = nullptr;        // likewise
    const Adjacency* adjacency = nullptr;  // of a mesh: laplacian of `conc`
    const std::vector<NamedStencil>* stencils = nullptr;
    // Of RANDOM: the key, and two words of the counter; the others are the cell's id and 0.
    std::int64_t seed = 1;
    std::uint32_t place = 0;
    std::uint32_t purpose = 0;

    std::size_t cells() const { return x.size(); }
};

// Whether an expression of a field, or else of a start, may read this; one of a picture may read everything.
bool seen_by_field(Quantity);
bool seen_at_start(Quantity);

// The expression's values in double precision, one a cell. Throws Error where it reads what the scene does not show.
std::vector<double> evaluate(const Expression&, const Scene&);

}  // namespace pelage
