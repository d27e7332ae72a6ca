// How many bytes a run will need, judged before anything is allocated.
#pragma once

#include "core/experiment.hpp"
#include "core/tissue.hpp"

#include <cstddef>
#include <cstdint>
#include <string>

namespace pelage::app {

struct Footprint {
    double cells = 0;   // at the end of the run, expansions included; double: absurd sizes must not overflow
    double host = 0;    // bytes in main memory
    double device = 0;  // bytes on an OpenCL device
};

Footprint footprint(const Experiment&, std::uint64_t last, Precision);

// The bytes this process may use: physical memory, or less where a control group says so.
double host_memory();

// Throws Error when the tissue will not fit into `available` bytes, or has more cells than can be addressed.
void check_host_memory(const Experiment&, const Footprint&, double available);

// Why the tissue will not fit into a device of `available` bytes; empty: it fits.
std::string why_not_on_device(const Footprint&, double available);

std::string readable_bytes(double bytes);  // "2.1 GiB"

}  // namespace pelage::app
