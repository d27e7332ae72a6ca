// The tables behind the names of colormaps.
#pragma once

#include "core/experiment.hpp"

#include <array>
#include <string>
#include <vector>

namespace pelage {

inline constexpr std::size_t slot_count = 100;

// Control points of inferno, viridis, magma or gray; empty for any other name.
std::vector<ColourStop> named_stops(const std::string& name);

// 100 colours from blue over cyan, green and yellow to red.
std::vector<std::array<std::uint8_t, 3>> heat_slots();

}  // namespace pelage
