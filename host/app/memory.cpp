// See memory.hpp.
#include "app/memory.hpp"

#include "core/error.hpp"
#include "core/prepattern.hpp"
#include "core/schedule.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <variant>

namespace pelage::app {

namespace {

// How often a rule acts in iterations 0 .. last - 1.
double activations(const Rule& rule, std::uint64_t last) {
    const std::uint64_t first = next_active(rule, 0);
    if (last == 0 || first > last - 1) return 0;
    const std::uint64_t count = (std::min(rule.until, last - 1) - first) / rule.every + 1;
    return static_cast<double>(count);
}

double final_cells(const Experiment& experiment, std::uint64_t last) {
    const auto matrix =
        std::find_if(experiment.prepattern.begin(), experiment.prepattern.end(),
                     [](const auto& statement) { return std::holds_alternative<CreateMatrix>(statement); });
    if (matrix == experiment.prepattern.end()) return static_cast<double>(count_cells(experiment));
    auto columns = static_cast<double>(std::get<CreateMatrix>(*matrix).columns);
    auto rows = static_cast<double>(std::get<CreateMatrix>(*matrix).rows);
    for (const Rule& rule : experiment.rules) {
        const auto* growth = std::get_if<Expand>(&rule.action);
        if (growth == nullptr) continue;
        columns += activations(rule, last) * static_cast<double>(growth->columns);
        rows += activations(rule, last) * static_cast<double>(growth->rows);
    }
    return columns * rows;
}

}  // namespace

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
        throw Error(fmt::format("{}: {:.0f} cells with {} chemicals need about {} of memory; there are {}",
                                experiment.source, footprint.cells, experiment.chemicals.size(),
                                readable_bytes(footprint.host), readable_bytes(available)));
    }
}

std::string why_not_on_device(const Footprint& footprint, double available) {
    if (footprint.device <= available) return {};
    return fmt::format("{:.0f} cells need about {} on the device, which has {}", footprint.cells,
                       readable_bytes(footprint.device), readable_bytes(available));
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
