// See space.hpp.
#include "core/space.hpp"

#include "core/error.hpp"
#include "core/visit.hpp"

#include <algorithm>
#include <optional>

namespace pelage {

namespace {

// What one statement creates; empty for those that create nothing.
std::optional<Space> created(const Statement& statement, const Experiment& experiment) {
    using Made = std::optional<Space>;
    return std::visit(Overloaded{
                          [&](const CreateMatrix& m) -> Made {
                              return Lattice{m.columns,
                                             m.rows,
                                             m.x,
                                             m.y,
                                             m.boundary,
                                             experiment.stencil,
                                             Arithmetic::fused,
                                             !m.charges,
                                             experiment.weights,
                                             m.charges};
                          },
                          [](const CreateGrid& grid) -> Made {
                              if (grid.arrangement != Arrangement::sqr_grid || grid.deviation != 0.0)
                                  return FreeCells{};
                              const Boundary boundary = grid.wrap ? Boundary::wrap : Boundary::no_flux;
                              return Lattice{grid.columns,          grid.rows, grid.x, grid.y, boundary, Stencil::moore,
                                             Arithmetic::published, false,     {},     false};
                          },
                          [&](const CreateVolume& v) -> Made {
                              const Stencil given = experiment.stencil;
                              return Volume{v.columns, v.rows, v.layers, v.boundary,
                                            of_volumes(given) ? given : Stencil::seven_point};
                          },
                          [](const CreateMesh& mesh) -> Made { return MeshCells{mesh.surface}; },
                          [](const CreateCell&) -> Made { return FreeCells{}; },
                          [](const CreateShape&) -> Made { return FreeCells{}; },
                          [](const UseChemical&) -> Made { return {}; },
                          [](const UsePolarity&) -> Made { return {}; },
                          [](const UseSeed&) -> Made { return {}; },
                          [](const SetCells&) -> Made { return {}; },
                      },
                      statement);
}

bool cells_leave_their_place(const Experiment& experiment) {
    return std::ranges::any_of(experiment.rules, [](const Rule& rule) {
        return std::holds_alternative<Divide>(rule.action) || std::holds_alternative<Move>(rule.action);
    });
}

}  // namespace

Space space_of(const Experiment& experiment) {
    std::optional<Space> found;
    for (const Statement& statement : experiment.prepattern) {
        const std::optional<Space> more = created(statement, experiment);
        if (!more) continue;
        if (found) return FreeCells{};
        found = more;
    }
    if (!found) return FreeCells{};
    const auto* lattice = std::get_if<Lattice>(&*found);
    if (lattice != nullptr && !lattice->expandable && cells_leave_their_place(experiment)) return FreeCells{};
    return *found;
}

const char* these_are(const Space& space) {
    return std::visit(
        Overloaded{[](const Lattice&) { return "this is a lattice"; },
                   [](const FreeCells&) { return "these are free cells"; },
                   [](const Volume&) { return "this is a volume"; }, [](const MeshCells&) { return "this is a mesh"; }},
        space);
}

void resize_lattice(Experiment& experiment, std::size_t columns, std::size_t rows) {
    const Space space = space_of(experiment);
    if (!std::holds_alternative<Lattice>(space)) {
        throw Error(experiment.source + (keeps_places(space) ? ": a volume has layers, too; it keeps its size"
                                                             : ": free cells have no columns and rows"));
    }
    const auto resize = [&](auto& lattice) {
        lattice.columns = columns;
        lattice.rows = rows;
    };
    for (Statement& statement : experiment.prepattern) {
        if (auto* matrix = std::get_if<CreateMatrix>(&statement)) resize(*matrix);
        if (auto* grid = std::get_if<CreateGrid>(&statement)) resize(*grid);
    }
}

}  // namespace pelage
