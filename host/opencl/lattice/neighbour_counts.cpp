// See neighbour_counts.hpp.
#include "opencl/lattice/neighbour_counts.hpp"

#include <algorithm>

namespace pelage {

namespace {

// How many of the `reach` places around `at` lie within `count`, itself included.
std::size_t within(std::size_t at, std::size_t count, std::size_t reach) {
    return std::min(at, reach) + 1 + std::min(count - 1 - at, reach);
}

std::vector<std::int32_t> count_in_volume(const Volume& volume) {
    std::vector<std::int32_t> counts(volume.columns * volume.rows * volume.layers);
    const bool open = volume.boundary != Boundary::no_flux;
    for (std::size_t cell = 0; cell < counts.size(); ++cell) {
        const std::size_t line = cell / volume.columns;
        const std::size_t across = open ? 3 : within(cell % volume.columns, volume.columns, 1);
        const std::size_t up = open ? 3 : within(line % volume.rows, volume.rows, 1);
        const std::size_t deep = open ? 3 : within(line / volume.rows, volume.layers, 1);
        const bool faces = volume.stencil == Stencil::seven_point;
        counts[cell] = static_cast<std::int32_t>(faces ? across + up + deep - 3 : across * up * deep - 1);
    }
    return counts;
}

}  // namespace

std::vector<std::int32_t> neighbour_counts(const LatticePlan& plan, const Grid& grid) {
    std::vector<std::int32_t> counts(grid.cells());
    if (plan.volume()) return count_in_volume(plan.as_volume());
    const bool five = plan.stencil == Stencil::five_point;
    const auto reach = static_cast<std::size_t>(plan.reach());
    for (std::size_t cell = 0; cell < counts.size(); ++cell) {
        const bool open = plan.boundary != Boundary::no_flux;
        const std::size_t across = open ? 2 * reach + 1 : within(cell % grid.columns, grid.columns, reach);
        const std::size_t up = open ? 2 * reach + 1 : within(cell / grid.columns, grid.rows, reach);
        counts[cell] = static_cast<std::int32_t>(five ? across + up - 2 : across * up - 1);
    }
    return counts;
}

}  // namespace pelage
