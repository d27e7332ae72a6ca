// How many bytes a run will need, judged before anything is allocated.
#pragma once

#include "core/experiment.hpp"
#include "core/tissue.hpp"

#include <cstddef>
#include <cstdint>
#include <string>

namespace pelage::app {

struct Footprint {
    double cells = 0;       // at the end of the run, expansions included; double: absurd sizes must not overflow
    double a_snapshot = 0;  // bytes of one cell's state on its way to a file, in double whatever the precision
    double snapshots = 0;   // that are there at once: one to be written, one to return to
    double reference = 0;   // bytes that the reference computes with
    double device = 0;      // bytes on an OpenCL device
    double film = 0;        // bytes for what is drawn beside the run

    double states() const { return cells * snapshots * a_snapshot; }
};

// What an OpenCL driver's compiler takes for itself, in this process, beside what the driver took when it was loaded.
// PoCL's takes 130 MiB for any program of ours; others are not known.
inline constexpr double compiler_bytes = 160.0 * (1 << 20);

Footprint footprint(const Experiment&, std::uint64_t last, Precision, bool resumed);

enum class Worked { by_reference, in_main_memory, on_a_card };  // the last two by OpenCL

// Throws Error when the tissue has more cells than can be addressed.
void check_cells(const Experiment&, const Footprint&);

// The same, or when it will not fit into `available` bytes.
void check_host_memory(const Experiment&, const Footprint&, Worked, double available);

// Why the tissue will not fit into a device of `available` bytes; empty: it fits.
std::string why_not_on_device(const Footprint&, double available);

std::string readable_bytes(double bytes);  // "2.1 GiB"

}  // namespace pelage::app
