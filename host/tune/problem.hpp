// What candidates are tried on: an experiment's lattice, cut down where it is large, and what makes two alike.
#pragma once

#include "core/experiment.hpp"
#include "core/snapshot.hpp"

#include <cstddef>
#include <cstdint>
#include <string>

namespace pelage::tune {

struct LatticeSize {
    std::size_t columns = 0;
    std::size_t rows = 0;
    std::size_t cells() const { return columns * rows; }
};

LatticeSize lattice_size(const Experiment&);  // at its beginning. Throws Error for free cells.

// The same experiment on a lattice no larger than that: the first columns and rows of its pictures; `set` statements
// that name cells beyond it are left out.
Experiment cut_down(Experiment, LatticeSize most);

struct Stage {
    Experiment experiment;
    Snapshot start;
};

// Where and on what candidates are compared and timed.
struct Problem {
    Stage verified;         // small, of odd sizes, so that bands, blocks and tiles end anywhere; its values are stirred
    Stage timed;            // at most `most_cells`
    std::uint64_t end = 0;  // iteration at which what is timed goes back to its start
};

// Iterations from `first` to `last` will be run. Throws Error for free cells.
Problem make_problem(const Experiment&, std::uint64_t first, std::uint64_t last, std::size_t most_cells);

// Cells that say enough about larger lattices: several times what caches hold.
std::size_t telling_cells(const std::string& device_type);

// "1024 x 512": columns and rows to the nearest power of two.
std::string size_class(LatticeSize);

// An experiment's text without comments, pictures, times of results and the values of numbers: what is left decides
// which kernel is made.
std::string rules_class(const std::string& text);

}  // namespace pelage::tune
