// See tile.hpp.
#include "opencl/lattice/tile.hpp"

#include <utility>

namespace pelage {

TiledStep::TiledStep(const Session& session, const Experiment& experiment, const LatticePlan& plan,
                     const std::vector<bool>& active, bool test_intervals, Choice choice)
    : FusedStep(session, experiment, plan, active, test_intervals, std::move(choice), tile_source,
                "pelage_lattice_tile") {}

FusedLaunch TiledStep::next_launch(const Grid& grid, std::uint64_t count) const {
    return tile_launch(grid, choice().cut, choice().width, count);
}

}  // namespace pelage
