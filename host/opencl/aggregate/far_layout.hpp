// What the host and the kernels of a far field tell each other, as both have it in memory.
#pragma once

#include "core/aggregate.hpp"
#include "core/far_grid.hpp"
#include "core/front.hpp"
#include "opencl/device/cl.hpp"

#include <limits>
#include <vector>

namespace pelage {

struct DeviceLevel {  // struct pelage_level of kernels/aggregate/far_tree.cl
    cl_int columns, rows, first, shift;
};

struct DeviceLeaf {  // struct pelage_leaf
    cl_long lowest = std::numeric_limits<cl_long>::max(), highest = 0;
    cl_int candidates = 0, chunk = -1, charges = 0, charge_chunk = -1;
};

struct DeviceFarFront {  // struct pelage_far_front
    cl_long lowest = std::numeric_limits<cl_long>::max(), lower = 0, upper = 0;
    cl_float eta = 0.0f;
    cl_int grain = 0, whole = 0;
    cl_uint last = no_site;
    cl_int charges = 0, candidates = 0, chunks = 0, left = -1, charge_chunks = 0, unused = 0;
};

struct DeviceFarParticle {  // struct pelage_far_particle of kernels/aggregate/far_draw.cl
    cl_float eta, size;
    cl_uint iteration, rule, key_low, key_high;
};

std::vector<DeviceLevel> device_levels(const FarGrid&);
DeviceFarParticle device_particle(const Particle&);

}  // namespace pelage
