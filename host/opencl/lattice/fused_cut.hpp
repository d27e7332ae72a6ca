// How lattices are cut into the bands and tiles of fused programs, and stretches of iterations into launches.
#pragma once

#include "opencl/device/device.hpp"
#include "opencl/device/options.hpp"
#include "opencl/lattice/emit_fused.hpp"
#include "opencl/lattice/passing.hpp"
#include "opencl/lattice/planes.hpp"

#include <cstddef>
#include <cstdint>

namespace pelage {

struct FusedLaunch {
    std::size_t steps = 1;    // levels of a pass
    std::size_t passes = 1;   // of one launch
    std::size_t vectors = 1;  // across a band or a tile, margins included
    std::size_t margin = 0;   // cells on either side of a band; 0: it is as wide as the lattice
    std::size_t bands = 1;    // work-groups along a row
    std::size_t strip = 1;    // rows of a work-group
    std::size_t strips = 1;   // work-groups up the columns
    bool together = false;    // they share the passes
};

struct Cut {
    FusedShape shape;
    std::size_t bytes = 0;  // of local memory; more than the device has where not even the smallest shape fits
};

// As the options ask (LatticeCut), or as is `usual` where they do not, cut down to what the device's local memory
// holds.
Cut stream_cut(const DeviceInfo&, const OpenclOptions&, const FusedFields&, std::size_t width);
Cut tile_cut(const DeviceInfo&, const OpenclOptions&, const FusedFields&, std::size_t width, const LatticeCut& usual);

// The next launch of `count` iterations to come.
FusedLaunch stream_launch(const DeviceInfo&, const Grid&, const FusedShape&, std::size_t width, std::uint64_t count);
FusedLaunch tile_launch(const Grid&, const FusedShape&, std::size_t width, std::uint64_t count);

}  // namespace pelage
