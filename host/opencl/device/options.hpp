// What a user may choose about an OpenCL device and how it is used.
#pragma once

#include "core/neighbours.hpp"
#include "core/precision.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <string>

namespace pelage {

// How a lattice carries out its iterations. The bits are the same whatever is chosen.
//   automatic  what is best for the device, the rules and the work to come; see lattice/choice.hpp
//   step       one launch an iteration
//   streamed   several iterations in one pass over memory. The program takes longer to compile than the others.
//   shared     work-groups share a lattice's steps and wait for each other; on processors, else as `step`
//   tiled      work-groups take tiles of the lattice into local memory for several iterations; for GPUs
// Free cells are stepped, or one work-group carries out many iterations (`shared`, and whatever else is not `step`).
enum class Path { automatic, step, streamed, shared, tiled };

inline constexpr std::array<const char*, 5> path_words{"automatic", "step", "streamed", "shared", "tiled"};
inline const char* word(Path path) { return path_words[static_cast<std::size_t>(path)]; }

// How streamed and tiled programs are cut to a device; 0: ours to choose. What does not fit the device's local memory
// or limits is cut down until it does. The bits are the same whatever is chosen.
struct LatticeCut {
    std::size_t depth = 0;    // most iterations in one pass over memory
    std::size_t columns = 0;  // of cells in a band or a tile, without margins
    std::size_t rows = 0;     // of a block of a band, or of a tile without margins
    std::size_t group = 0;    // work-items of a group

    bool operator==(const LatticeCut&) const = default;
};

struct OpenclOptions {
    std::optional<std::string> device;  // index, type or part of the name; see choose_device
    Precision precision = Precision::single_;
    bool use_cache = true;  // compiled programs kept on disk
    // By way of OpenCL's binaries from PoCL, too: being asked for one, it compiles every kernel once more, so that
    // otherwise the files that it writes are kept.
    bool cache_twice = false;
    // Lets the compiler contract and reorder floating-point arithmetic: faster on some devices, and equality with
    // the reference, even from run to run of another build, is given up.
    bool fast = false;
    std::size_t units = 0;       // compute units that work is cut for, at most; 0: all that the device has
    std::size_t work_group = 0;  // work-items in a group; 0: ours to choose
    std::size_t variants = 16;   // programs for sets of active rules before one that tests all intervals itself
    std::size_t width = 0;       // cells a work-item handles side by side, 1, 2, 4, 8 or 16; 0: ours to choose
    Path path = Path::automatic;
    LatticeCut cut;
    // For verification: every buffer lies between guard zones, looked at after each launch, and what a launch must
    // write is filled with NaN first. Each launch is waited for.
    bool guarded = false;
    NeighbourSearch neighbours = NeighbourSearch::bins;  // of free cells
    SpatialSorting sorting;                              // for spatial_sorting
};

}  // namespace pelage
