// See memory.hpp.
#include "app/memory.hpp"

#include "core/counted.hpp"
#include "core/error.hpp"
#include "core/forecast.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <fstream>

namespace pelage::app {

Footprint footprint(const Experiment& experiment, std::uint64_t last, Precision precision) {
    const auto chemicals = static_cast<double>(experiment.chemicals.size());
    const auto mappings = static_cast<double>(experiment.mappings.size());
    const double scalar = precision == Precision::double_ ? 8 : 4;
    constexpr double integers = 4 + 4 + 1;  // birth, neighbours, fixed
    const double snapshot = 8 * (2 * chemicals + mappings + 4) + integers;
    const double state = scalar * (2 * chemicals + mappings + 4) + integers;
    const double cells = final_cells(experiment, last);
    // The first state, one to return to and one on its way to a file; a state before and one after the iteration.
    return {cells, cells * (3 * snapshot + 2 * state), cells * 2 * state};
}

double host_memory() {
    double bytes = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
    for (const char* file : {"/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory/memory.limit_in_bytes"}) {
        double limit = 0;
        if (std::ifstream(file) >> limit && limit > 0) bytes = std::min(bytes, limit);
    }
    return bytes;
}

void check_host_memory(const Experiment& experiment, const Footprint& footprint, double available) {
    if (footprint.cells > static_cast<double>(largest_cell_count)) {
        throw Error(fmt::format("{}: the tissue would grow to {:.3g} cells; {} can be addressed", experiment.source,
                                footprint.cells, largest_cell_count));
    }
    if (footprint.host > available) {
        throw Error(fmt::format("{}: {:.0f} {} with {} need about {} of memory; there are {}", experiment.source,
                                footprint.cells, footprint.cells == 1 ? "cell" : "cells",
                                counted(experiment.chemicals.size(), "chemical"), readable_bytes(footprint.host),
                                readable_bytes(available)));
    }
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
