// See memory.hpp.
#include "app/memory.hpp"

#include "app/finite_guard.hpp"
#include "core/counted.hpp"
#include "core/error.hpp"
#include "core/forecast.hpp"
#include "core/space.hpp"
#include "core/surface.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace pelage::app {

namespace {

std::size_t most_neighbours(const Space& space) {
    const auto* volume = std::get_if<Volume>(&space);
    const auto* mesh = std::get_if<MeshCells>(&space);
    if (mesh != nullptr) return mesh->surface->adjacency.indices.size() / mesh->surface->cells() + 1;
    if (volume == nullptr) return 8;
    return volume->stencil == Stencil::seven_point ? 6 : 26;
}

}  // namespace

Footprint footprint(const Experiment& experiment, std::uint64_t last, Precision precision, bool resumed) {
    const auto chemicals = static_cast<double>(experiment.chemicals.size());
    const auto mappings = static_cast<double>(experiment.mappings.size());
    const double scalar = precision == Precision::double_ ? 8 : 4;
    constexpr double integers = 4 + 4 + 1;  // birth, neighbours, fixed
    const auto neighbours = static_cast<double>(most_neighbours(space_of(experiment)));
    const double lists = neighbours * 15 + 8 + 4;  // of neighbours, where they begin, their count
    const double state = scalar * (2 * chemicals + mappings + 4) + integers;
    Footprint need;
    need.cells = final_cells(experiment, last);
    need.a_snapshot = 8 * (2 * chemicals + mappings + 4) + integers;
    need.snapshots = resumed || need.cells <= static_cast<double>(FiniteGuard::largest_kept) ? 2 : 1;
    need.device = need.cells * 2 * state;
    need.reference = need.device + need.cells * lists;
    return need;
}

void check_cells(const Experiment& experiment, const Footprint& need) {
    if (need.cells <= static_cast<double>(largest_cell_count)) return;
    throw Error(fmt::format("{}: the tissue would grow to {:.3g} cells; {} can be addressed", experiment.source,
                            need.cells, largest_cell_count));
}

void check_host_memory(const Experiment& experiment, const Footprint& need, Worked worked, double available) {
    check_cells(experiment, need);
    const double work = worked == Worked::by_reference     ? need.reference
                        : worked == Worked::in_main_memory ? need.device
                                                           : 0;
    const double cells = need.states() + work;
    const double compiler = worked == Worked::by_reference ? 0 : compiler_bytes;
    const double all = cells + compiler + need.film;
    if (all <= available) return;
    std::string beside;
    if (compiler != 0) beside += fmt::format(", and {} for the OpenCL driver's compiler", readable_bytes(compiler));
    if (need.film != 0) beside += fmt::format(", and {} for the film", readable_bytes(need.film));
    throw Error(
        fmt::format("{}: {:.0f} {} with {} need about {} of memory ({:.0f} bytes a cell: {:.0f} for its state in a "
                    "result, {:.0f} to compute{}); {} may be used",
                    experiment.source, need.cells, need.cells == 1 ? "cell" : "cells",
                    counted(experiment.chemicals.size(), "chemical"), readable_bytes(all), cells / need.cells,
                    need.states() / need.cells, work / need.cells, beside, readable_bytes(available)));
}

std::string why_not_on_device(const Footprint& footprint, double available) {
    if (footprint.device <= available) return {};
    return fmt::format("{:.0f} {} about {} on the device, which has {}", footprint.cells,
                       footprint.cells == 1 ? "cell needs" : "cells need", readable_bytes(footprint.device),
                       readable_bytes(available));
}

std::string readable_bytes(double bytes) {
    constexpr std::array units{"B", "KiB", "MiB", "GiB", "TiB", "PiB"};
    std::size_t unit = 0;
    while (bytes >= 1024 && unit + 1 < units.size()) {
        bytes /= 1024;
        ++unit;
    }
    return fmt::format("{:.{}f} {}", bytes, bytes < 10 && unit > 0 ? 1 : 0, units[unit]);
}

}  // namespace pelage::app
