// See step.hpp.
#include "opencl/lattice/step.hpp"

#include "core/forecast.hpp"
#include "opencl/device/launch.hpp"
#include "opencl/lattice/emit_lattice.hpp"
#include "opencl/lattice/means.hpp"

#include <algorithm>
#include <utility>

namespace pelage {

namespace {

// Work-groups share the steps of lattices up to this many cells; larger ones are worth a launch a step.
constexpr std::size_t shared_below = 1'000'000;
// A second thread is woken for no less work than this, in cell-updates; it takes as long as some ten thousand.
constexpr std::size_t worth_waking = 100'000;
// Cells that a strip should have, or threads wait for each other more than they work.
constexpr std::size_t cells_a_strip = 2'000;
// Work of one launch, so that the host gets its turn every few milliseconds.
constexpr std::size_t cells_a_launch = 8'000'000;
constexpr std::size_t steps_a_launch = 4096;

}  // namespace

bool is_cpu(const DeviceInfo& device) { return device.type == "cpu" && !device.software_rasteriser(); }
bool is_cpu(const Session& session) { return is_cpu(session.info()); }

std::size_t vector_lanes(const DeviceInfo& device, Precision precision) {
    const std::uint32_t lanes =
        precision == Precision::double_ ? device.vector_width_double : device.vector_width_float;
    std::size_t width = 1;
    while (width < 16 && 2 * width <= lanes) width *= 2;
    return width;
}

std::size_t lattice_width(const Session& session) {
    if (session.options().width != 0) return session.options().width;
    return is_cpu(session) ? vector_lanes(session.info(), session.options().precision) : 1;
}

bool tiles_pay(const Session& session) {
    if (session.info().type != "gpu" || session.info().software_rasteriser()) return false;
    return session.device().getInfo<CL_DEVICE_LOCAL_MEM_TYPE>() == CL_LOCAL;
}

bool caches_hold(const DeviceInfo& device, double bytes) {
    constexpr double of_a_thread = 1'500'000;  // of its second level, much of it
    return bytes < of_a_thread * static_cast<double>(device.running_units());
}

bool streaming_pays(const Experiment& experiment, const std::vector<bool>& active, std::uint64_t iteration,
                    double cells, bool cached, double done) {
    constexpr double least_cells = 15'000;  // smaller ones are no faster streamed than with shared steps
    if (cells < least_cells) return false;
    const double enough = cached ? 5e9 : 2e9;
    const std::uint64_t last = experiment.last_iteration();
    if (iteration >= last) return done >= enough;
    const std::uint64_t end = std::min(last, end_of_set(experiment, active, iteration));
    return static_cast<double>(end - iteration) * cells >= enough;
}

bool shares_steps(const Session& session) {
    return is_cpu(session) && session.options().work_group <= 1 && session.options().fusion != Fusion::never;
}

namespace {

LaunchShape shared_shape(const Session& session, const Grid& grid, std::uint64_t count) {
    LaunchShape shape;
    if (grid.cells() > shared_below) {  // so many strips that threads find work however late they come
        shape.bands = std::min<std::size_t>(grid.rows, 4 * session.info().compute_units);
        shape.band = divided(grid.rows, shape.bands);
        shape.bands = divided(grid.rows, shape.band);
        return shape;
    }
    const std::size_t most = std::clamp<std::size_t>(cells_a_launch / grid.cells(), 1, steps_a_launch);
    shape.steps = static_cast<std::size_t>(std::min<std::uint64_t>(most, count));
    if (grid.cells() * shape.steps < worth_waking) {
        shape.band = grid.rows;
        return shape;
    }
    const std::size_t strips = std::min<std::size_t>(session.info().running_units(), grid.cells() / cells_a_strip);
    shape.band = divided(grid.rows, std::clamp<std::size_t>(strips, 1, grid.rows));
    shape.bands = divided(grid.rows, shape.band);
    return shape;
}

}  // namespace

LaunchShape launch_shape(const Session& session, const Grid& grid, std::size_t width, bool together,
                         std::uint64_t count) {
    LaunchShape shape;
    const std::size_t most = std::max<std::size_t>(1, session.info().max_work_group);
    const std::size_t group = std::min(session.options().work_group, most);
    const std::size_t strips = divided(grid.columns, width);
    if (!is_cpu(session)) {
        shape.work_group = group != 0 ? group : std::min<std::size_t>(64, most);
        shape.across = divided(strips, shape.work_group) * shape.work_group;
        shape.bands = grid.rows;
        return shape;
    }
    if (together) return shared_shape(session, grid, count);
    shape.work_group = group != 0 ? group : 1;
    shape.across = shape.work_group;
    shape.bands = std::min<std::size_t>(grid.rows, 4 * session.info().compute_units);
    shape.band = divided(grid.rows, shape.bands);
    return shape;
}

LatticeStep::LatticeStep(const Session& session, const Experiment& experiment, const LatticePlan& plan,
                         const std::vector<bool>& active, bool test_intervals, std::shared_ptr<LatticeMeans> means)
    : session_(session),
      width_(lattice_width(session)),
      seed_(static_cast<std::uint64_t>(experiment.run_seed())),
      together_(shares_steps(session)),
      shared_(session),
      means_(std::move(means)) {
    const RuleText rules = emit_rules(experiment, active, session.options().precision, test_intervals);
    writes_rates_ = !rules.use.rates_written.empty();
    writes_polarity_ = !rules.use.polarizes.empty();
    const std::string source = lattice_source(experiment, plan, rules, bounded_chemicals(experiment),
                                              session.options().precision, width_, together_, means_ != nullptr);
    kernel_ = cl::Kernel(session.build(source), "pelage_lattice_step");
}

std::string LatticeStep::describe() const {
    if (together_) return "fused, steps shared among threads";
    return std::string("not fused, one launch an iteration: ") + (is_cpu(session_) || tiles_pay(session_)
                                                                      ? "as the options ask for"
                                                                      : "the device has no local memory of its own");
}

// `steps` iterations from `first` on.
void LatticeStep::set_arguments(LatticeState& state, const cl::Buffer& parameters, const LaunchShape& shape,
                                std::uint64_t first, std::uint64_t steps) {
    Arguments arguments(session_, kernel_);
    state.conc().add_to(arguments, true);
    state.rates().add_to(arguments, writes_rates_);
    state.polarity().add_to(arguments, writes_polarity_);
    arguments.add(state.mappings().now(), state.birth().now(), state.neighbours().now(), state.places(), parameters);
    const Grid& grid = state.grid();
    arguments.add(grid.columns, grid.rows, grid.pitch(), shape.band);
    arguments.add(static_cast<cl_uint>(first), static_cast<cl_uint>(steps), static_cast<cl_uint>(seed_ & 0xffffffffu),
                  static_cast<cl_uint>(seed_ >> 32));
    if (together_) shared_.prepare(arguments, shape.bands, steps);
    if (means_) arguments.add(means_->of(state));
}

void LatticeStep::enqueue(LatticeState& state, const cl::Buffer& parameters, std::uint64_t first, std::uint64_t count,
                          Pace& pace) {
    for (std::uint64_t done = 0; done < count;) {
        const LaunchShape shape = launch_shape(session_, state.grid(), width_, together_, count - done);
        const std::uint64_t steps = std::min<std::uint64_t>(shape.steps, count - done);
        set_arguments(state, parameters, shape, first + done, steps);
        session_.launch(kernel_, cl::NDRange(shape.across, shape.bands), cl::NDRange(shape.work_group, 1));
        pace.launched();
        done += steps;
        if (steps % 2 == 0) continue;  // an even number of steps ends where it began
        state.conc().swap();
        if (writes_rates_) state.rates().swap();
        if (writes_polarity_) state.polarity().swap();
    }
}

}  // namespace pelage
