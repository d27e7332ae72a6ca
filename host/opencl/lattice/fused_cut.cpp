// See fused_cut.hpp.
#include "opencl/lattice/fused_cut.hpp"

#include "opencl/lattice/divided.hpp"

#include <algorithm>
#include <cmath>

namespace pelage {

namespace {

// Below this many cells one thread is done before a second has woken up.
constexpr std::size_t alone_below = 40'000;
// Work of one launch, so that the host gets its turn every few milliseconds.
constexpr std::size_t cells_a_stretch = 4'000'000;
// Scratch and carried rows of a group should stay in its core's second-level cache.
constexpr std::size_t scratch_bytes = 512 * 1024;

// Turns of all loops that a work-item takes in one pass of kernels/lattice/stream.cl, no fewer.
std::size_t turns_of_pass(const FusedShape& shape, const FusedLaunch& launch) {
    const std::size_t vectors = divided(launch.vectors, shape.group);
    const std::size_t copies = 2 * shape.rows * (1 + 2 * vectors);
    const std::size_t level = 1 + vectors * (64 + 16 * shape.rows);
    return divided(launch.strip + 2 * launch.steps, shape.rows) * (copies + launch.steps * level);
}

// Iterations of one pass. All passes alike: one of few steps at the end would cost as much memory traffic as the
// others.
std::size_t steps_of_pass(const Grid& grid, std::size_t depth, std::uint64_t count) {
    // A margin may not reach past the lattice's far side.
    const std::size_t deepest = std::min({depth, grid.columns, grid.rows});
    const std::uint64_t passes = (count + deepest - 1) / deepest;
    return static_cast<std::size_t>((count + passes - 1) / passes);
}

// So many bands or a few more, that `units` threads get equal shares of them or of two strips a thread.
std::size_t even_bands(std::size_t bands, std::size_t units) {
    if (bands >= units) return divided(bands, units) * units;
    while (2 * units % bands != 0) ++bands;
    return bands;
}

// Work-groups along a row, as many as are needed and all alike.
FusedLaunch across(const Grid& grid, const FusedShape& shape, std::size_t width, std::size_t steps, std::size_t units) {
    FusedLaunch launch;
    launch.steps = steps;
    launch.margin = steps;
    const std::size_t margins = 2 * steps;
    launch.bands = even_bands(divided(grid.columns, shape.vectors * width - margins), units);
    launch.vectors = divided(divided(grid.columns, launch.bands) + margins, width);
    launch.bands = divided(grid.columns, launch.vectors * width - margins);
    return launch;
}

// One band, without margins.
FusedLaunch whole_rows(const Grid& grid, std::size_t width, std::size_t steps) {
    FusedLaunch launch;
    launch.steps = steps;
    launch.vectors = divided(grid.columns, width);
    return launch;
}

// Iterations of a pass where no launch is to be saved: deep ones compute more margin (on average 1.5 rows for each
// iteration and strip), shallow ones fetch and put back the lattice more often (about the time of one iteration).
std::size_t shared_depth(const FusedShape& shape, std::size_t strip) {
    const double best = std::sqrt(static_cast<double>(strip) / 1.5);
    return std::min(shape.depth, std::max<std::size_t>(4, static_cast<std::size_t>(best)));
}

std::size_t wished(std::size_t value, std::size_t otherwise) { return value == 0 ? otherwise : value; }

// Work-items of a group; a CPU runs them one after the other.
std::size_t group_size(const DeviceInfo& device, const OpenclOptions& options, std::size_t otherwise) {
    const std::size_t most = std::max<std::size_t>(1, device.max_work_group);
    return std::min(most, wished(options.cut.group, device.processor() ? 1 : otherwise));
}

std::size_t scalar_bytes(const OpenclOptions& options) { return options.precision == Precision::double_ ? 8 : 4; }

}  // namespace

Cut stream_cut(const DeviceInfo& device, const OpenclOptions& options, const FusedFields& fields, std::size_t width) {
    const LatticeCut& wish = options.cut;
    const std::size_t scalar = scalar_bytes(options);
    FusedShape shape;
    shape.prefetch = device.processor();
    shape.depth = wished(wish.depth, 16);
    shape.rows = wished(wish.rows, 4);
    shape.group = group_size(device, options, 64);
    shape.together = device.processor() && options.work_group <= 1 && shape.group == 1;
    std::size_t columns = wished(wish.columns, 384);
    const auto vectors = [&] { return divided(columns + 2 * shape.depth, width); };
    const auto bytes = [&] {  // as lattice/stream.cl counts them, at most
        const std::size_t line = 128 / scalar;
        const std::size_t slot = (divided(vectors() * width + 2, line) | 1) * line;
        const std::size_t scratch = 2 * (shape.rows + 2) * fields.all * slot + 32;
        return scalar * (scratch + shape.depth * vectors() * width * (3 * fields.all + 2 * fields.seen));
    };
    const std::size_t there = device.local_memory;
    const std::size_t wanted = wish.depth == 0 ? std::min(scratch_bytes, there) : there;
    while (shape.depth > 4 && bytes() > wanted) shape.depth -= 4;
    while (bytes() > there) {
        if (columns > 64) {
            columns /= 2;
        } else if (shape.rows > 2) {
            shape.rows /= 2;
        } else if (columns > 8) {
            columns /= 2;
        } else if (shape.depth > 1) {
            shape.depth /= 2;
        } else {
            break;
        }
    }
    shape.vectors = vectors();
    return {shape, bytes()};
}

FusedLaunch stream_launch(const DeviceInfo& device, const Grid& grid, const FusedShape& shape, std::size_t width,
                          std::uint64_t count) {
    const bool whole = grid.columns <= shape.vectors * width;
    const bool alone = whole && grid.cells() < alone_below;
    const std::size_t units = alone ? 1 : device.running_units();
    const std::size_t depth = whole && shape.together ? shared_depth(shape, divided(grid.rows, units)) : shape.depth;
    const std::size_t steps = steps_of_pass(grid, depth, count);
    FusedLaunch launch = whole ? whole_rows(grid, width, steps) : across(grid, shape, width, steps, units);
    const std::size_t groups = grid.rows < 16 * launch.steps * units ? units : 2 * units;
    launch.strips = std::clamp<std::size_t>(divided(groups, launch.bands), 1, divided(grid.rows, 2 * launch.steps));
    launch.strip = divided(grid.rows, launch.strips);
    launch.strips = divided(grid.rows, launch.strip);
    const bool ends_loops = device.software_rasteriser();
    while (ends_loops && launch.strip > 1 && turns_of_pass(shape, launch) > DeviceInfo::rasteriser_turns) {
        launch.strip = divided(launch.strip, 2);
        launch.strips = divided(grid.rows, launch.strip);
    }
    // Who shares passes waits for the strips beside its own and no others: none may be lower than a margin.
    const auto lowest = [&] { return grid.rows - (launch.strips - 1) * launch.strip; };
    while (shape.together && launch.bands == 1 && launch.strips > 1 && lowest() < launch.steps) {
        launch.strip = divided(grid.rows, launch.strips - 1);
        launch.strips = divided(grid.rows, launch.strip);
    }
    launch.together = shape.together && launch.bands == 1 && launch.strips > 1;
    if (launch.together || launch.bands * launch.strips == 1) {
        std::size_t most = std::max<std::size_t>(1, cells_a_stretch / (grid.cells() * launch.steps));
        if (ends_loops)
            most = std::clamp<std::size_t>(DeviceInfo::rasteriser_turns / turns_of_pass(shape, launch), 1, most);
        launch.passes = std::min<std::uint64_t>(most, count / launch.steps);
    }
    return launch;
}

Cut tile_cut(const DeviceInfo& device, const OpenclOptions& options, const FusedFields& fields, std::size_t width,
             const LatticeCut& usual) {
    const LatticeCut& wish = options.cut;
    const std::size_t scalar = scalar_bytes(options);
    FusedShape shape;
    shape.depth = wished(wish.depth, usual.depth);
    shape.rows = wished(wish.rows, usual.rows);
    shape.group = group_size(device, options, usual.group);
    std::size_t columns = wished(wish.columns, usual.columns);
    const auto vectors = [&] { return divided(columns + 2 * shape.depth, width); };
    const auto bytes = [&] {  // as lattice/tile.cl counts them
        return scalar * (2 * (shape.rows + 2 * shape.depth) * fields.all * vectors() * width + 32);
    };
    const std::size_t there = device.local_memory;
    while (bytes() > there) {
        if (shape.rows > 8) {
            shape.rows /= 2;
        } else if (shape.depth > 2) {
            shape.depth /= 2;
        } else if (columns > 4) {
            columns /= 2;
        } else if (shape.rows > 1) {
            shape.rows /= 2;
        } else if (shape.depth > 1) {
            shape.depth = 1;
        } else {
            break;
        }
    }
    shape.vectors = vectors();
    return {shape, bytes()};
}

FusedLaunch tile_launch(const Grid& grid, const FusedShape& shape, std::size_t width, std::uint64_t count) {
    FusedLaunch launch = across(grid, shape, width, steps_of_pass(grid, shape.depth, count), 1);
    launch.strips = divided(grid.rows, shape.rows);
    launch.strip = divided(grid.rows, launch.strips);
    launch.strips = divided(grid.rows, launch.strip);
    return launch;
}

}  // namespace pelage
