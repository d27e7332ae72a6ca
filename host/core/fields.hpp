// Fields: numbers that each place of a lattice has, computed from where it lies or taken from a picture.
#pragma once

#include "core/experiment.hpp"
#include "core/precision.hpp"
#include "core/snapshot.hpp"
#include "core/surface.hpp"

#include <cstddef>
#include <vector>

namespace pelage {

// The size of a lattice or a volume, and a lattice's centre.
struct Extent {
    std::size_t columns = 0;
    std::size_t rows = 0;
    double origin_x = 0.0;
    double origin_y = 0.0;
    std::size_t layers = 0;  // of a volume
};
Extent extent_of(const Snapshot&);

// Centres of cells that lie 2 apart around `origin`.
std::vector<double> centres(double origin, std::size_t count);

// [field][cell] of all fields of the experiment. They are computed in double precision and then rounded to that of the
// run. Throws Error where a value of a field with a name is no finite number.
std::vector<std::vector<double>> field_values(const Experiment&, const Extent&, Precision);

// [field][cell] of those fields of a mesh that are made of blobs, likewise; empty for the others, which are computed
// where they are read.
std::vector<std::vector<double>> mesh_blobs(const Experiment&, const MeshSurface&, Precision);

// Parts of rules' expressions that depend on the place alone and cost something become fields without a name: they are
// computed once, not in every iteration. Does nothing for free cells.
void compute_places_once(Experiment&);

}  // namespace pelage
