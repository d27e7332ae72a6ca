// See step.hpp.
#include "opencl/volume/step.hpp"

#include "opencl/device/launch.hpp"
#include "opencl/device/rule_options.hpp"
#include "opencl/lattice/divided.hpp"
#include "opencl/lattice/emit_lattice.hpp"

#include <algorithm>
#include <chrono>

namespace pelage {

namespace {

// Strips of rows for each thread, so that threads find work however late they come.
constexpr std::size_t strips_a_thread = 4;

// Rows that a strip needs, or its neighbours' edges would meet within it.
constexpr std::size_t rows_a_strip(std::size_t steps) { return 2 * steps + 1; }

// A wave on a torus must not catch up with its own beginning, and all of its steps must have begun before the first
// ends.
bool wave_fits(const Volume& volume, std::size_t steps) { return volume.layers >= steps + 2; }

}  // namespace

VolumeShape volume_shape(const DeviceInfo& device, const Choice& choice, const Volume& volume, std::uint64_t count) {
    VolumeShape shape;
    shape.work_group = choice.cut.group;
    if (!device.processor()) {
        shape.across = divided(divided(volume.columns, choice.width), shape.work_group) * shape.work_group;
        shape.strips = volume.rows;
        shape.deep = volume.layers;
        return shape;
    }
    shape.across = shape.work_group;
    const std::size_t many = strips_a_thread * std::max<std::size_t>(1, device.running_units());
    shape.strips = std::min(volume.rows, many);
    const auto steps = static_cast<std::size_t>(std::min<std::uint64_t>(choice.cut.depth, count));
    if (choice.path != Path::streamed || steps < 2 || shape.across > 1 || !wave_fits(volume, steps)) return shape;
    shape.steps = steps;
    const std::size_t rows = std::max(choice.cut.rows, rows_a_strip(steps));
    shape.strips = std::max<std::size_t>(1, volume.rows / rows);
    return shape;
}

VolumeStep::VolumeStep(const Session& session, const Experiment& experiment, const LatticePlan& plan,
                       const std::vector<bool>& active, bool test_intervals, const Choice& choice)
    : session_(session),
      width_(choice.width),
      volume_(plan.as_volume()),
      cuts_(session.info(), choice, volume_),
      seed_(static_cast<std::uint64_t>(experiment.run_seed())) {
    const RuleText rules = emit_rules(experiment, active, session.options().precision, test_intervals);
    writes_rates_ = !rules.use.rates_written.empty();
    const std::string source = lattice_source(experiment, plan, rules, bounded_chemicals(experiment),
                                              session.options().precision, width_, false, false);
    kernel_ = cl::Kernel(session.build(source, rule_options(session)), "pelage_volume_step");
}

void VolumeStep::launch(LatticeState& state, const cl::Buffer& parameters, const VolumeShape& shape,
                        std::uint64_t first) {
    Arguments arguments(session_, kernel_);
    state.conc().add_to(arguments, true);
    state.rates().add_to(arguments, writes_rates_);
    arguments.add(state.mappings().now(), state.birth().now(), state.neighbours().now(), state.places(),
                  state.fields().now(), parameters);
    arguments.add(volume_.columns, volume_.rows, volume_.layers, state.grid().pitch(), shape.strips,
                  divided(volume_.layers, shape.deep));
    arguments.add(static_cast<cl_uint>(first), static_cast<cl_int>(shape.steps),
                  static_cast<cl_uint>(seed_ & 0xffffffffu), static_cast<cl_uint>(seed_ >> 32));
    const cl::NDRange global(shape.across, shape.strips, shape.deep), local(shape.work_group, 1, 1);
    for (cl_int between = 0; between < (shape.steps > 1 && shape.strips > 1 ? 2 : 1); ++between) {
        kernel_.setArg(arguments.next(), between);
        session_.launch(kernel_, global, local);
    }
}

void VolumeStep::launch_timed(LatticeState& state, const cl::Buffer& parameters, const VolumeShape& shape,
                              std::uint64_t first) {
    using Clock = std::chrono::steady_clock;
    session_.queue().finish();
    const Clock::time_point start = Clock::now();
    launch(state, parameters, shape, first);
    session_.queue().finish();
    cuts_.took(std::chrono::duration<double>(Clock::now() - start).count() / static_cast<double>(shape.steps));
}

void VolumeStep::enqueue(LatticeState& state, const cl::Buffer& parameters, std::uint64_t first, std::uint64_t count,
                         Pace& pace) {
    for (std::uint64_t done = 0; done < count;) {
        const VolumeShape shape = volume_shape(session_.info(), cuts_.now(), volume_, count - done);
        const bool whole = shape.steps == cuts_.now().cut.depth;  // not the last ones before something happens
        if (cuts_.searching() && whole) {
            launch_timed(state, parameters, shape, first + done);
        } else {
            launch(state, parameters, shape, first + done);
        }
        pace.launched();
        done += shape.steps;
        if (shape.steps % 2 == 0) continue;  // an even number of steps ends where it began
        state.conc().swap();
        if (writes_rates_) state.rates().swap();
    }
}

}  // namespace pelage
