// Exact neighbour sets from an OpenCL device.
#pragma once

#include "core/neighbours.hpp"
#include "opencl/device/session.hpp"
#include "opencl/neighbours/bins.hpp"

#include <optional>
#include <span>

namespace pelage {

// All pairs with dx * dx + dy * dy < radius * radius, evaluated in the session's precision from dx = x[j] - x[i] (dy
// alike). A point without a finite place has no neighbours. Throws Error when x and y differ in length, when radius is
// not positive and when the device has not enough memory.
Neighbours opencl_neighbours(const Session&, std::span<const double> x, std::span<const double> y,
                             double radius = interaction_range, std::optional<NeighbourTuning> = {});

// Lists of places, in physical order, as lists of ids, in order of id. ids[place] is the point at that place.
Neighbours read_lists(const Session&, const cl::Buffer& ids, const DeviceLists&, std::size_t points);

}  // namespace pelage
