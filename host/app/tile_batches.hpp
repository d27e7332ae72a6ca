// Tiles of a sweep that a device runs together: those of one structure are a batch (core/batch.hpp).
#pragma once

#include "app/memory.hpp"
#include "app/tile_runner.hpp"
#include "opencl/backend.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace pelage::app {

// Tiles that one of `jobs` threads takes at one time, of a device that gains by it: so many that they fill the device,
// no more than the host has room for, and so few that a batch ends, and its rows are written, after a minute or two.
std::size_t tiles_a_batch(const Footprint&, std::uint64_t last, std::size_t tiles, std::size_t jobs, double memory);

using FinishedTile = std::function<void(std::size_t tile, const std::string& row)>;

// Runs tiles, those of one structure together as far as the device has room; what cannot be a member runs alone. False:
// interrupted. Any thread.
bool run_together(const TileRunner&, OpenclBackend&, const std::vector<std::size_t>& tiles, const FinishedTile&);

}  // namespace pelage::app
