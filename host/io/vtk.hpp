// Files for ParaView and other VTK programs: XML, numbers in base64. Field data: "TimeValue", the simulated time (time
// steps added up), and "iteration".
#pragma once

#include "core/experiment.hpp"
#include "core/snapshot.hpp"
#include "core/tissue.hpp"

#include <filesystem>

namespace pelage {

// .vti: a lattice as ImageData of columns x rows squares of side 1, since diffusion on a lattice counts in cells: its
// lengths are half of those in cell radii (Snapshot::x, CSV). Cell data: one Float32 (double_: Float64) array a
// chemical, named after it. Row 0 is the lowest. A volume has cubes, layer 0 the lowest in z. Throws Error for free
// cells, when arrays do not fit, or the file cannot be written.
void write_vti(const std::filesystem::path&, const Snapshot&, const Experiment&, Precision);

// .vtp: cells as points of PolyData; point data: "id", "birth", "neighbours", "fixed" (integers), "polarity" (vectors),
// and for each chemical "conc NAME" and "diff NAME"; lengths are in cell radii. Lattices are allowed. Throws Error as
// above.
void write_vtp(const std::filesystem::path&, const Snapshot&, const Experiment&, Precision);

}  // namespace pelage
