// See colormaps.hpp.
#include "io/colormaps.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>

namespace pelage {
namespace {

// Evenly spaced from 0 to 1, as 0xRRGGBB.
std::vector<ColourStop> even_stops(std::initializer_list<std::uint32_t> colours) {
    std::vector<ColourStop> stops;
    for (const auto colour : colours) {
        stops.push_back({static_cast<double>(stops.size()) / static_cast<double>(colours.size() - 1),
                         {static_cast<std::uint8_t>(colour >> 16), static_cast<std::uint8_t>(colour >> 8 & 0xff),
                          static_cast<std::uint8_t>(colour & 0xff)}});
    }
    return stops;
}

}  // namespace

// Every fifteenth of the 256 colours of the maps of Smith, van der Walt & Firing (2015, CC0).
std::vector<ColourStop> named_stops(const std::string& name) {
    if (name == "gray") return even_stops({0x000000, 0xffffff});
    if (name == "inferno") {
        return even_stops({0x000004, 0x0a0722, 0x1e0c45, 0x380962, 0x510e6c, 0x69166e, 0x801f6c, 0x982766, 0xb0315b,
                           0xc63d4d, 0xd94d3d, 0xe9612b, 0xf47918, 0xfa9407, 0xfcb014, 0xf8cd37, 0xf2ea69, 0xfcffa4});
    }
    if (name == "viridis") {
        return even_stops({0x440154, 0x481769, 0x472a7a, 0x433d84, 0x3d4e8a, 0x355e8d, 0x2e6d8e, 0x297b8e, 0x23898e,
                           0x1f978b, 0x21a585, 0x2eb37c, 0x46c06f, 0x65cb5e, 0x89d548, 0xb0dd2f, 0xd8e219, 0xfde725});
    }
    if (name == "magma") {
        return even_stops({0x000004, 0x090720, 0x1a1042, 0x311165, 0x4a1079, 0x621980, 0x792282, 0x912b81, 0xaa337d,
                           0xc23b75, 0xd9466b, 0xec5860, 0xf7725c, 0xfc8e64, 0xfeaa74, 0xfec68a, 0xfde2a3, 0xfcfdbf});
    }
    return {};
}

std::vector<std::array<std::uint8_t, 3>> heat_slots() {
    const auto ramp = [](double distance) {  // 1 up to a distance of 1, falling to 0 at 2
        return static_cast<std::uint8_t>(std::lround(255 * std::clamp(2.0 - distance, 0.0, 1.0)));
    };
    std::vector<std::array<std::uint8_t, 3>> slots(slot_count);
    for (std::size_t i = 0; i < slot_count; ++i) {
        const double hue =
            4.0 * static_cast<double>(i) / static_cast<double>(slot_count - 1);  // 0 blue, 2 green, 4 red
        slots[i] = {ramp(4.0 - hue), ramp(std::abs(hue - 2.0)), ramp(hue)};
    }
    return slots;
}

}  // namespace pelage
