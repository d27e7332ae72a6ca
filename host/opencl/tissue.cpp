// See tissue.hpp.
#include "opencl/tissue.hpp"

#include "core/space.hpp"
#include "core/visit.hpp"
#include "opencl/aggregate/tissue.hpp"
#include "opencl/cells/tissue.hpp"
#include "opencl/lattice/tissue.hpp"
#include "opencl/mesh/tissue.hpp"
#include "opencl/volume/tissue.hpp"

namespace pelage {

std::unique_ptr<Tissue> make_opencl_tissue(std::shared_ptr<const Session> session,
                                           std::shared_ptr<const Experiment> experiment, const Snapshot& initial) {
    return std::visit(Overloaded{[&](const Lattice& lattice) {
                                     return lattice.charges ? make_opencl_aggregate(session, experiment, initial)
                                                            : make_opencl_lattice(session, experiment, initial);
                                 },
                                 [&](const Volume&) { return make_opencl_volume(session, experiment, initial); },
                                 [&](const MeshCells&) { return make_opencl_mesh(session, experiment, initial); },
                                 [&](const FreeCells&) {
                                     CellsOptions options;
                                     options.search = session->options().neighbours;
                                     options.sorting = session->options().sorting;
                                     return make_opencl_cells(session, experiment, initial, options);
                                 }},
                      space_of(*experiment));
}

}  // namespace pelage
