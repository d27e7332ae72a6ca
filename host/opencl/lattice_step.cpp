// See lattice_step.hpp.
#include "opencl/lattice_step.hpp"

#include "opencl/emit_lattice.hpp"

#include <algorithm>

namespace pelage {

namespace {

// Below this many cells one thread is done before a second has woken up.
constexpr std::size_t alone_below = 40'000;
// Work of one launch, so that the host gets its turn every few milliseconds.
constexpr std::size_t cells_a_launch = 4'000'000;

std::size_t divided(std::size_t a, std::size_t b) { return (a + b - 1) / b; }

}  // namespace

bool is_cpu(const Session& session) { return session.info().type == "cpu" && !session.info().software_rasteriser(); }

std::size_t lattice_width(const Session& session) {
    if (session.options().width != 0) return session.options().width;
    if (!is_cpu(session)) return 1;
    const std::uint32_t lanes =
        session.is_double() ? session.info().vector_width_double : session.info().vector_width_float;
    std::size_t width = 1;
    while (width < 16 && 2 * width <= lanes) width *= 2;
    return width;
}

LaunchShape launch_shape(const Session& session, const Grid& grid, std::size_t width) {
    LaunchShape shape;
    const std::size_t group = session.options().work_group;
    const std::size_t strips = divided(grid.columns, width);
    if (!is_cpu(session)) {
        shape.work_group = group != 0 ? group : std::min<std::size_t>(64, session.info().max_work_group);
        shape.across = divided(strips, shape.work_group) * shape.work_group;
        shape.bands = grid.rows;
        return shape;
    }
    shape.work_group = group != 0 ? group : 1;
    shape.across = shape.work_group;
    const bool alone = shape.across == 1 && grid.cells() < alone_below;
    shape.bands = alone ? 1 : std::min<std::size_t>(grid.rows, 4 * session.info().compute_units);
    shape.band = divided(grid.rows, shape.bands);
    if (alone) shape.steps = std::clamp<std::size_t>(cells_a_launch / grid.cells(), 1, 4096);
    return shape;
}

LatticeStep::LatticeStep(const Session& session, const Experiment& experiment, const LatticePlan& plan,
                         const std::vector<bool>& active, bool test_intervals)
    : session_(session), width_(lattice_width(session)), seed_(static_cast<std::uint64_t>(experiment.run_seed())) {
    const RuleText rules = emit_rules(experiment, active, session.options().precision, test_intervals);
    writes_rates_ = !rules.use.rates_written.empty();
    writes_polarity_ = !rules.use.polarizes.empty();
    const std::string source =
        lattice_source(experiment, plan, rules, bounded_chemicals(experiment), session.options().precision, width_);
    kernel_ = cl::Kernel(session.build(source), "pelage_lattice_step");
}

void LatticeStep::set_buffers(LatticeState& state) {
    kernel_.setArg(0, state.conc().now());
    kernel_.setArg(1, state.conc().next());
    kernel_.setArg(2, state.rates().now());
    kernel_.setArg(3, writes_rates_ ? state.rates().next() : state.rates().now());
    kernel_.setArg(4, state.polarity().now());
    kernel_.setArg(5, writes_polarity_ ? state.polarity().next() : state.polarity().now());
}

void LatticeStep::set_shape(LatticeState& state, const cl::Buffer& parameters, const LaunchShape& shape) {
    kernel_.setArg(6, state.mappings().now());
    kernel_.setArg(7, state.birth().now());
    kernel_.setArg(8, state.neighbours().now());
    kernel_.setArg(9, state.places());
    kernel_.setArg(10, parameters);
    kernel_.setArg(11, static_cast<cl_int>(state.grid().columns));
    kernel_.setArg(12, static_cast<cl_int>(state.grid().rows));
    kernel_.setArg(13, static_cast<cl_int>(state.grid().pitch()));
    kernel_.setArg(14, static_cast<cl_int>(shape.band));
    kernel_.setArg(17, static_cast<cl_uint>(seed_ & 0xffffffffu));
    kernel_.setArg(18, static_cast<cl_uint>(seed_ >> 32));
}

void LatticeStep::enqueue(LatticeState& state, const cl::Buffer& parameters, std::uint64_t first, std::uint64_t count,
                          Pace& pace) {
    const LaunchShape shape = launch_shape(session_, state.grid(), width_);
    set_shape(state, parameters, shape);
    for (std::uint64_t done = 0; done < count;) {
        const std::uint64_t steps = std::min<std::uint64_t>(shape.steps, count - done);
        set_buffers(state);
        kernel_.setArg(15, static_cast<cl_uint>(first + done));
        kernel_.setArg(16, static_cast<cl_uint>(steps));
        session_.queue().enqueueNDRangeKernel(kernel_, cl::NullRange, cl::NDRange(shape.across, shape.bands),
                                              cl::NDRange(shape.work_group, 1));
        pace.launched();
        done += steps;
        if (steps % 2 == 0) continue;  // an even number of steps ends where it began
        state.conc().swap();
        if (writes_rates_) state.rates().swap();
        if (writes_polarity_) state.polarity().swap();
    }
}

}  // namespace pelage
