// Round spots at random places of a lattice, a volume or a mesh.
#pragma once

#include "core/experiment.hpp"
#include "core/space.hpp"
#include "core/surface.hpp"

#include <cstdint>
#include <vector>

namespace pelage {

// For each cell. `place`: that of the field, so that each field has spots of its own.
std::vector<double> blob_values(const BlobField&, const Lattice&, std::int64_t seed, std::size_t place);
std::vector<double> blob_values(const BlobField&, const Volume&, std::int64_t seed, std::size_t place);
std::vector<double> blob_values(const BlobField&, const MeshSurface&, std::int64_t seed, std::size_t place);

}  // namespace pelage
