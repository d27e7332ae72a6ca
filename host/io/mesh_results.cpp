// See mesh_results.hpp.
#include "io/mesh_results.hpp"

#include "core/error.hpp"
#include "core/space.hpp"
#include "io/mesh_file.hpp"
#include "io/shade.hpp"
#include "io/shape.hpp"

#include <fmt/format.h>

#include <variant>
#include <vector>

namespace pelage {

namespace {

std::vector<Rgb> colours_of(const Brush& brush) {
    std::vector<Rgb> colours;
    colours.reserve(brush.cells());
    for (std::size_t cell = 0; cell < brush.cells(); ++cell) colours.push_back(brush(cell));
    return colours;
}

}  // namespace

const MeshSurface* surface_of(const Experiment& experiment) {
    for (const Statement& statement : experiment.prepattern) {
        if (const auto* mesh = std::get_if<CreateMesh>(&statement)) return mesh->surface.get();
    }
    return nullptr;
}

Picture mesh_view(const MeshSurface& surface, const Output& output, const Brush& brush, std::size_t side) {
    return shade(surface.mesh, colours_of(brush), output.view.value_or(default_view), side);
}

void write_coloured_mesh(const std::filesystem::path& path, const MeshSurface& surface, const Brush& brush,
                         Precision precision) {
    write_mesh_ply(path, surface.mesh, colours_of(brush), {}, precision);
}

void write_surface_vtp(const std::filesystem::path& path, const Snapshot& snapshot, const Experiment& experiment,
                       Precision precision) {
    check_shape(snapshot, experiment);
    const MeshSurface* surface = surface_of(experiment);
    if (surface == nullptr || surface->cells() != snapshot.cells())
        throw Error(fmt::format("'{}' cannot be written: the state lies on no mesh of the experiment", path.string()));
    std::vector<VertexValues> values;
    for (std::size_t i = 0; i < experiment.chemicals.size(); ++i) {
        values.push_back({"conc " + experiment.chemicals[i].name, snapshot.conc[i]});
        values.push_back({"diff " + experiment.chemicals[i].name, snapshot.diff[i]});
    }
    write_mesh_vtp(path, surface->mesh, values, experiment.time_at(snapshot.iteration), snapshot.iteration, precision);
}

}  // namespace pelage
