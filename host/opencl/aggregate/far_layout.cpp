// See far_layout.hpp.
#include "opencl/aggregate/far_layout.hpp"

#include <bit>
#include <cstdint>

namespace pelage {

DeviceFarParticle device_particle(const Particle& one) {
    const auto key = static_cast<std::uint64_t>(one.seed);
    return {one.eta,
            one.size,
            static_cast<cl_uint>(one.iteration),
            static_cast<cl_uint>(one.rule),
            static_cast<cl_uint>(key),
            static_cast<cl_uint>(key >> 32)};
}

std::vector<DeviceLevel> device_levels(const FarGrid& grid) {
    std::vector<DeviceLevel> levels;
    for (const FarLevel& level : grid.levels) {
        levels.push_back({static_cast<cl_int>(level.columns), static_cast<cl_int>(level.rows),
                          static_cast<cl_int>(level.first), std::countr_zero(level.side)});
    }
    return levels;
}

}  // namespace pelage
