// See stream_step.hpp.
#include "opencl/stream_step.hpp"

#include "core/error.hpp"
#include "opencl/emit_lattice.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace pelage {

namespace {

// Below this many cells one thread is done before a second has woken up.
constexpr std::size_t alone_below = 40'000;
// Work of one launch, so that the host gets its turn every few milliseconds.
constexpr std::size_t cells_a_launch = 4'000'000;
// Scratch and carried rows of a group should stay in its core's second-level cache.
constexpr std::size_t scratch_bytes = 512 * 1024;

// rusticl on llvmpipe ends a work-item silently after 65,535 turns of all its loops.
constexpr std::size_t turns_a_launch = 60'000;

std::size_t divided(std::size_t a, std::size_t b) { return (a + b - 1) / b; }

// Turns of all loops that a work-item takes in one pass of kernels/lattice_stream.cl, no fewer.
std::size_t turns_of_pass(const StreamShape& shape, const StreamLaunch& launch) {
    const std::size_t vectors = divided(launch.vectors, shape.group);
    const std::size_t copies = 2 * shape.block * (1 + 2 * vectors);
    const std::size_t level = 1 + vectors * (64 + 16 * shape.block);
    return divided(launch.strip + 2 * launch.steps, shape.block) * (copies + launch.steps * level);
}

}  // namespace

StreamShape stream_shape(const Session& session, const StreamFields& fields, std::size_t width) {
    StreamShape shape;
    shape.prefetch = is_cpu(session);
    if (!is_cpu(session)) shape.group = std::clamp<std::size_t>(session.info().max_work_group, 1, 64);
    std::size_t columns = 256;
    const auto vectors = [&] { return divided(columns + 2 * shape.depth, width); };
    const auto bytes = [&] {  // as lattice_stream.cl counts them, at most
        const std::size_t line = 128 / session.scalar_bytes();
        const std::size_t slot = (divided(vectors() * width, line) | 1) * line;
        const std::size_t scratch = 2 * (shape.block + 2) * fields.all * slot + 32;
        return session.scalar_bytes() *
               (scratch + shape.depth * vectors() * width * (3 * fields.all + 2 * fields.seen));
    };
    const std::size_t there = session.device().getInfo<CL_DEVICE_LOCAL_MEM_SIZE>();
    while (shape.depth > 4 && bytes() > std::min(scratch_bytes, there)) shape.depth -= 4;
    while (bytes() > there) {
        if (columns > 64) {
            columns /= 2;
        } else if (shape.block > 2) {
            shape.block /= 2;
        } else if (columns > 8) {
            columns /= 2;
        } else if (shape.depth > 1) {
            shape.depth /= 2;
        } else {
            throw Error(
                fmt::format("fused iterations of {} values a cell need {} bytes of local memory; device '{}' "
                            "has {}",
                            fields.all, bytes(), session.info().name, there));
        }
    }
    shape.vectors = vectors();
    return shape;
}

StreamLaunch stream_launch(const Session& session, const Grid& grid, const StreamShape& shape, std::size_t width,
                           std::uint64_t count) {
    StreamLaunch launch;
    // A margin may not reach past the lattice's far side.
    const std::size_t deepest = std::min({shape.depth, grid.columns, grid.rows});
    // All passes alike: one of few steps at the end would cost as much memory traffic as the others.
    const std::uint64_t passes = (count + deepest - 1) / deepest;
    launch.steps = static_cast<std::size_t>((count + passes - 1) / passes);
    const std::size_t margin = 2 * launch.steps;
    launch.bands = divided(grid.columns, shape.vectors * width - margin);
    launch.vectors = divided(divided(grid.columns, launch.bands) + margin, width);
    launch.bands = divided(grid.columns, launch.vectors * width - margin);
    const bool alone = launch.bands == 1 && grid.cells() < alone_below;
    const std::size_t groups = alone ? 1 : 2 * session.info().compute_units;
    launch.strips = std::clamp<std::size_t>(divided(groups, launch.bands), 1, divided(grid.rows, 2 * launch.steps));
    launch.strip = divided(grid.rows, launch.strips);
    launch.strips = divided(grid.rows, launch.strip);
    const bool ends_loops = session.info().software_rasteriser();
    while (ends_loops && launch.strip > 1 && turns_of_pass(shape, launch) > turns_a_launch) {
        launch.strip = divided(launch.strip, 2);
        launch.strips = divided(grid.rows, launch.strip);
    }
    if (launch.bands * launch.strips == 1) {
        std::size_t most = std::max<std::size_t>(1, cells_a_launch / (grid.cells() * launch.steps));
        if (ends_loops) most = std::clamp<std::size_t>(turns_a_launch / turns_of_pass(shape, launch), 1, most);
        launch.passes = std::min<std::uint64_t>(most, count / launch.steps);
    }
    return launch;
}

StreamStep::StreamStep(const Session& session, const Experiment& experiment, const LatticePlan& plan,
                       const std::vector<bool>& active, bool test_intervals)
    : session_(session), width_(lattice_width(session)), seed_(static_cast<std::uint64_t>(experiment.run_seed())) {
    const RuleText rules = emit_rules(experiment, active, session.options().precision, test_intervals);
    writes_rates_ = !rules.use.rates_written.empty();
    writes_polarity_ = !rules.use.polarizes.empty();
    writes_mappings_ = !rules.use.mappings_written.empty();
    shape_ = stream_shape(session, stream_fields(experiment, plan, rules.use), width_);
    const std::string source = stream_source(experiment, plan, rules, bounded_chemicals(experiment),
                                             session.options().precision, width_, shape_);
    kernel_ = cl::Kernel(session.build(source), "pelage_lattice_stream");
}

std::string StreamStep::describe() const {
    return fmt::format("fused, streamed, up to {} iterations in one pass over memory", shape_.depth);
}

void StreamStep::set_planes(LatticeState& state) {
    const auto set = [&](cl_uint place, Planes& planes, bool written) {
        kernel_.setArg(place, planes.now());
        kernel_.setArg(place + 1, written ? planes.next() : planes.now());
    };
    set(0, state.conc(), true);
    set(2, state.rates(), writes_rates_);
    set(4, state.polarity(), writes_polarity_);
    set(6, state.mappings(), writes_mappings_);
    kernel_.setArg(8, state.birth().now());
    kernel_.setArg(9, state.neighbours().now());
}

void StreamStep::swap_planes(LatticeState& state) const {
    state.conc().swap();
    if (writes_rates_) state.rates().swap();
    if (writes_polarity_) state.polarity().swap();
    if (writes_mappings_) state.mappings().swap();
}

void StreamStep::enqueue(LatticeState& state, const cl::Buffer& parameters, std::uint64_t first, std::uint64_t count,
                         Pace& pace) {
    while (count > 0) {
        const StreamLaunch launch = stream_launch(session_, state.grid(), shape_, width_, count);
        set_planes(state);
        kernel_.setArg(10, state.places());
        kernel_.setArg(11, parameters);
        kernel_.setArg(12, static_cast<cl_int>(state.grid().columns));
        kernel_.setArg(13, static_cast<cl_int>(state.grid().rows));
        kernel_.setArg(14, static_cast<cl_int>(state.grid().pitch()));
        kernel_.setArg(15, static_cast<cl_int>(launch.vectors));
        kernel_.setArg(16, static_cast<cl_int>(launch.strip));
        kernel_.setArg(17, static_cast<cl_uint>(first));
        kernel_.setArg(18, static_cast<cl_int>(launch.steps));
        kernel_.setArg(19, static_cast<cl_int>(launch.passes));
        kernel_.setArg(20, static_cast<cl_uint>(seed_ & 0xffffffffu));
        kernel_.setArg(21, static_cast<cl_uint>(seed_ >> 32));
        session_.launch(kernel_, cl::NDRange(launch.bands * shape_.group, launch.strips), cl::NDRange(shape_.group, 1));
        pace.launched();
        if (launch.passes % 2 != 0) swap_planes(state);
        first += launch.steps * launch.passes;
        count -= launch.steps * launch.passes;
    }
}

}  // namespace pelage
