// What kind of tissue an experiment makes, and what follows from the kind alone.
#pragma once

#include "core/experiment.hpp"

#include <cstddef>
#include <memory>
#include <variant>

namespace pelage {

// published: the order of operations of Malheiros & Walter's program, without fma, for a sqr_grid: each rule
//   new += s * f * dt, then each neighbour in turn new += rate * (theirs - mine) * dt.
// fused: ours, for a matrix: new = fma(s * dt, f, new), then one fma with the whole stencil sum.
enum class Arithmetic { published, fused };

// Cells in rows and columns, their neighbours given by a stencil: a matrix, or a single sqr_grid that holds all cells,
// without jitter and without divide and move rules.
struct Lattice {
    std::size_t columns = 0;  // at the start
    std::size_t rows = 0;
    double x = 0.0, y = 0.0;  // centre, in units of cell radius
    Boundary boundary = Boundary::no_flux;
    Stencil stencil = Stencil::nine_point;
    Arithmetic arithmetic = Arithmetic::fused;
    bool expandable = false;  // `expand` may insert columns and rows
    StencilWeights weights;   // of Stencil::own
    bool charges = false;     // the cells are sites of an aggregate, which grows by one site at a time

    int reach() const { return stencil == Stencil::own ? reach_of(weights.size()) : 1; }  // of the stencil
};

// Cells in layers of rows of columns, a neighbour at each face, or at each face, edge and corner.
struct Volume {
    std::size_t columns = 0;
    std::size_t rows = 0;
    std::size_t layers = 0;
    Boundary boundary = Boundary::no_flux;
    Stencil stencil = Stencil::seven_point;
};

// Cells with centres anywhere in the plane; those nearer than 3 radii are neighbours.
struct FreeCells {};

// The vertices of a mesh, which exchange along its edges.
struct MeshCells {
    std::shared_ptr<const MeshSurface> surface;  // never null
};

using Space = std::variant<Lattice, FreeCells, Volume, MeshCells>;

// Whether cells stay where they are, each with the same neighbours: in every space but that of free cells.
inline bool keeps_places(const Space& space) { return !std::holds_alternative<FreeCells>(space); }

// Whether cells lie in columns and rows.
inline bool on_grid(const Space& space) {
    return std::holds_alternative<Lattice>(space) || std::holds_alternative<Volume>(space);
}

// What an experiment of that kind is, for messages: "this is a volume", "these are free cells".
const char* these_are(const Space&);

// Read off the `create` statements and the rules. Nothing else decides what kind of tissue an experiment is.
Space space_of(const Experiment&);

// Gives the statement that makes the lattice another size. Throws Error where there is no lattice.
void resize_lattice(Experiment&, std::size_t columns, std::size_t rows);

}  // namespace pelage
