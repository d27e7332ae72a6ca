// What a run leaves of a tissue on a mesh: views, coloured surfaces, surfaces with all values.
#pragma once

#include "core/experiment.hpp"
#include "core/snapshot.hpp"
#include "core/surface.hpp"
#include "core/tissue.hpp"
#include "io/brush.hpp"
#include "io/picture.hpp"

#include <cstddef>
#include <filesystem>

namespace pelage {

inline constexpr std::size_t view_side = 800;  // pixels

// The experiment's mesh; null where it has none.
const MeshSurface* surface_of(const Experiment&);

// The mesh in the brush's colours, from where the output is seen.
Picture mesh_view(const MeshSurface&, const Output&, const Brush&, std::size_t side = view_side);

// .ply: the mesh in the brush's colours.
void write_coloured_mesh(const std::filesystem::path&, const MeshSurface&, const Brush&, Precision);

// .vtp: the mesh with "conc NAME" and "diff NAME" of each chemical. Throws Error where there is no mesh, where the
// snapshot is none of its, or when the file cannot be written.
void write_surface_vtp(const std::filesystem::path&, const Snapshot&, const Experiment&, Precision);

}  // namespace pelage
