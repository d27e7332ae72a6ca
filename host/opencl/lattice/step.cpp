// See step.hpp.
#include "opencl/lattice/step.hpp"

#include "opencl/device/launch.hpp"
#include "opencl/device/rule_options.hpp"
#include "opencl/lattice/divided.hpp"
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

// Who shares steps waits for the strips beside its own and no others: none may be lower than cells are looked at.
void raise_strips(LaunchShape& shape, std::size_t rows, std::size_t reach) {
    while (shape.bands > 1 && rows - (shape.bands - 1) * shape.band < reach) {
        shape.band = divided(rows, shape.bands - 1);
        shape.bands = divided(rows, shape.band);
    }
}

LaunchShape shared_shape(const DeviceInfo& device, const Grid& grid, std::uint64_t count) {
    LaunchShape shape;
    if (grid.cells() > shared_below) {  // so many strips that threads find work however late they come
        shape.bands = std::min<std::size_t>(grid.rows, 4 * device.compute_units);
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
    const std::size_t strips = std::min<std::size_t>(device.running_units(), grid.cells() / cells_a_strip);
    shape.band = divided(grid.rows, std::clamp<std::size_t>(strips, 1, grid.rows));
    shape.bands = divided(grid.rows, shape.band);
    return shape;
}

}  // namespace

LaunchShape batch_shape(const Grid& grid, std::uint64_t count, std::size_t lattices_a_thread) {
    LaunchShape shape;
    shape.band = grid.rows;
    const std::size_t most = cells_a_launch / (grid.cells() * lattices_a_thread);
    shape.steps =
        static_cast<std::size_t>(std::min<std::uint64_t>(std::clamp<std::size_t>(most, 1, steps_a_launch), count));
    return shape;
}

LaunchShape launch_shape(const DeviceInfo& device, const Choice& choice, const Grid& grid, std::uint64_t count,
                         std::size_t reach) {
    LaunchShape shape;
    if (choice.path == Path::shared) {
        shape = shared_shape(device, grid, count);
        raise_strips(shape, grid.rows, reach);
        return shape;
    }
    shape.work_group = choice.cut.group;
    if (!device.processor()) {
        shape.across = divided(divided(grid.columns, choice.width), shape.work_group) * shape.work_group;
        shape.bands = grid.rows;
        return shape;
    }
    shape.across = shape.work_group;
    shape.bands = std::min<std::size_t>(grid.rows, 4 * device.compute_units);
    shape.band = divided(grid.rows, shape.bands);
    return shape;
}

LatticeStep::LatticeStep(const Session& session, const Experiment& experiment, const LatticePlan& plan,
                         const std::vector<bool>& active, bool test_intervals, Choice choice,
                         std::shared_ptr<LatticeMeans> means)
    : session_(session),
      choice_(std::move(choice)),
      seed_(static_cast<std::uint64_t>(experiment.run_seed())),
      shared_(session),
      means_(std::move(means)) {
    const RuleText rules = emit_rules(experiment, active, session.options().precision, test_intervals);
    reach_ = std::max(static_cast<std::size_t>(plan.reach()), rules.use.reach);
    writes_rates_ = !rules.use.rates_written.empty();
    writes_polarity_ = !rules.use.polarizes.empty();
    const std::string source =
        lattice_source(experiment, plan, rules, bounded_chemicals(experiment), session.options().precision,
                       choice_.width, choice_.path == Path::shared, means_ != nullptr, choice_.cut.batch);
    kernel_ = cl::Kernel(session.build(source, rule_options(session)), "pelage_lattice_step");
}

// `steps` iterations from `first` on.
void LatticeStep::set_arguments(LatticeState& state, const cl::Buffer& parameters, const LaunchShape& shape,
                                std::uint64_t first, std::uint64_t steps) {
    Arguments arguments(session_, kernel_);
    state.conc().add_to(arguments, true);
    state.rates().add_to(arguments, writes_rates_);
    state.polarity().add_to(arguments, writes_polarity_);
    arguments.add(state.mappings().now(), state.birth().now(), state.neighbours().now(), state.places(),
                  state.fields().now(), parameters);
    const Grid& grid = state.grid();
    arguments.add(grid.columns, grid.rows, grid.pitch(), shape.band);
    arguments.add(static_cast<cl_uint>(first), static_cast<cl_uint>(steps), static_cast<cl_uint>(seed_ & 0xffffffffu),
                  static_cast<cl_uint>(seed_ >> 32));
    if (choice_.path == Path::shared) shared_.prepare(arguments, shape.bands, steps);
    if (means_) arguments.add(means_->of(state));
    if (choice_.cut.batch) arguments.add(state.running_list());
}

LaunchShape LatticeStep::next_shape(const LatticeState& state, std::uint64_t count) const {
    const DeviceInfo& device = session_.info();
    if (choice_.cut.batch && device.processor() && choice_.cut.group == 1)
        return batch_shape(state.grid(), count, divided(state.running(), device.running_units()));
    return launch_shape(device, choice_, state.grid(), count, reach_);
}

void LatticeStep::enqueue(LatticeState& state, const cl::Buffer& parameters, std::uint64_t first, std::uint64_t count,
                          Pace& pace) {
    for (std::uint64_t done = 0; done < count;) {
        const LaunchShape shape = next_shape(state, count - done);
        const std::uint64_t steps = std::min<std::uint64_t>(shape.steps, count - done);
        set_arguments(state, parameters, shape, first + done, steps);
        session_.launch(kernel_, cl::NDRange(shape.across, shape.bands, state.running()),
                        cl::NDRange(shape.work_group, 1, 1));
        pace.launched();
        done += steps;
        if (steps % 2 == 0) continue;  // an even number of steps ends where it began
        state.conc().swap();
        if (writes_rates_) state.rates().swap();
        if (writes_polarity_) state.polarity().swap();
    }
}

}  // namespace pelage
