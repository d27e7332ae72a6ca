// Pictures of a report: a roofline and a scaling plot.
#pragma once

#include "bench/measure.hpp"

#include <filesystem>

namespace pelage::bench {

// "speed.png" -> "speed.roofline.png": updates as floating-point operations a second against operations a byte, under
// what the first device can do at most.
std::filesystem::path roofline_file(const std::filesystem::path&);

// "speed.png" -> "speed.scaling.png": time of one iteration against cells.
std::filesystem::path scaling_file(const std::filesystem::path&);

// Writes both. Throws Error naming the file and the reason.
void plot(const Report&, const std::filesystem::path&);

}  // namespace pelage::bench
