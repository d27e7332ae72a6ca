// See stream_step.hpp.
#include "opencl/stream_step.hpp"

#include "core/error.hpp"
#include "opencl/emit_lattice.hpp"

#include <algorithm>

namespace pelage {

namespace {

// Below this many cells one thread is done before a second has woken up.
constexpr std::size_t alone_below = 40'000;
// Work of one launch, so that the host gets its turn every few milliseconds.
constexpr std::size_t cells_a_launch = 4'000'000;
// Scratch and carried rows of a group should stay in its core's second-level cache.
constexpr std::size_t scratch_bytes = 512 * 1024;

std::size_t divided(std::size_t a, std::size_t b) { return (a + b - 1) / b; }

}  // namespace

StreamShape stream_shape(const Session& session, std::size_t fields, std::size_t width) {
    StreamShape shape;
    shape.vectors = divided(256 + 2 * shape.depth, width);
    const std::size_t bytes = session.scalar_bytes() * shape.vectors * width * fields;
    while (shape.depth > 4 && bytes * (3 * shape.depth + 2 * shape.block) > scratch_bytes) shape.depth /= 2;
    return shape;
}

StreamLaunch stream_launch(const Session& session, const Grid& grid, const StreamShape& shape, std::size_t width,
                           std::uint64_t count) {
    StreamLaunch launch;
    // A margin may not reach past the lattice's far side.
    const std::size_t deepest = std::min({shape.depth, grid.columns, grid.rows});
    launch.steps = std::min<std::uint64_t>(deepest, count);
    const std::size_t margin = 2 * launch.steps;
    launch.bands = divided(grid.columns, shape.vectors * width - margin);
    launch.vectors = divided(divided(grid.columns, launch.bands) + margin, width);
    launch.bands = divided(grid.columns, launch.vectors * width - margin);
    const bool alone = launch.bands == 1 && grid.cells() < alone_below;
    const std::size_t groups = alone ? 1 : 2 * session.info().compute_units;
    launch.strips = std::clamp<std::size_t>(divided(groups, launch.bands), 1, divided(grid.rows, 2 * launch.steps));
    launch.strip = divided(grid.rows, launch.strips);
    launch.strips = divided(grid.rows, launch.strip);
    if (launch.bands * launch.strips == 1) {
        const std::size_t most = std::max<std::size_t>(1, cells_a_launch / (grid.cells() * launch.steps));
        launch.passes = std::min<std::uint64_t>(most, count / launch.steps);
    }
    return launch;
}

StreamStep::StreamStep(const Session& session, const Experiment& experiment, const LatticePlan& plan,
                       const std::vector<bool>& active, bool test_intervals)
    : session_(session),
      width_(lattice_width(session)),
      shape_(stream_shape(session, experiment.chemicals.size(), width_)),
      seed_(static_cast<std::uint64_t>(experiment.run_seed())) {
    const RuleText rules = emit_rules(experiment, active, session.options().precision, test_intervals);
    const std::string reason = why_not_fused(plan, rules.use);
    if (!reason.empty()) throw Error("iterations cannot be fused: " + reason);
    const std::string source = stream_source(experiment, plan, rules, bounded_chemicals(experiment), width_, shape_);
    kernel_ = cl::Kernel(session.build(source), "pelage_lattice_stream");
}

void StreamStep::enqueue(LatticeState& state, const cl::Buffer& parameters, std::uint64_t first, std::uint64_t count,
                         Pace& pace) {
    while (count > 0) {
        const StreamLaunch launch = stream_launch(session_, state.grid(), shape_, width_, count);
        kernel_.setArg(0, state.conc().now());
        kernel_.setArg(1, state.conc().next());
        kernel_.setArg(2, state.places());
        kernel_.setArg(3, parameters);
        kernel_.setArg(4, static_cast<cl_int>(state.grid().columns));
        kernel_.setArg(5, static_cast<cl_int>(state.grid().rows));
        kernel_.setArg(6, static_cast<cl_int>(state.grid().pitch()));
        kernel_.setArg(7, static_cast<cl_int>(launch.vectors));
        kernel_.setArg(8, static_cast<cl_int>(launch.strip));
        kernel_.setArg(9, static_cast<cl_uint>(first));
        kernel_.setArg(10, static_cast<cl_int>(launch.steps));
        kernel_.setArg(11, static_cast<cl_int>(launch.passes));
        kernel_.setArg(12, static_cast<cl_uint>(seed_ & 0xffffffffu));
        kernel_.setArg(13, static_cast<cl_uint>(seed_ >> 32));
        session_.queue().enqueueNDRangeKernel(kernel_, cl::NullRange,
                                              cl::NDRange(launch.bands * shape_.group, launch.strips),
                                              cl::NDRange(shape_.group, 1));
        pace.launched();
        if (launch.passes % 2 != 0) state.conc().swap();
        first += launch.steps * launch.passes;
        count -= launch.steps * launch.passes;
    }
}

}  // namespace pelage
