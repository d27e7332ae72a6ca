// See fused_step.hpp.
#include "opencl/lattice/fused_step.hpp"

#include "opencl/device/rule_options.hpp"
#include "opencl/lattice/emit_lattice.hpp"

#include <utility>

namespace pelage {

FusedStep::FusedStep(const Session& session, const Experiment& experiment, const LatticePlan& plan,
                     const std::vector<bool>& active, bool test_intervals, Choice choice, SourceOf source,
                     const char* kernel)
    : session_(session), choice_(std::move(choice)), seed_(static_cast<std::uint64_t>(experiment.run_seed())) {
    const RuleText rules = emit_rules(experiment, active, session.options().precision, test_intervals);
    writes_rates_ = !rules.use.rates_written.empty();
    writes_polarity_ = !rules.use.polarizes.empty();
    writes_mappings_ = !rules.use.mappings_written.empty();
    const cl::Program program = session.build(source(experiment, plan, rules, bounded_chemicals(experiment),
                                                     session.options().precision, choice_.width, choice_.cut),
                                              rule_options(session));
    kernel_ = cl::Kernel(program, kernel);
}

void FusedStep::swap_planes(LatticeState& state) const {
    state.conc().swap();
    if (writes_rates_) state.rates().swap();
    if (writes_polarity_) state.polarity().swap();
    if (writes_mappings_) state.mappings().swap();
}

void FusedStep::set_arguments(LatticeState& state, const cl::Buffer& parameters, const FusedLaunch& launch,
                              std::uint64_t first) {
    Arguments arguments(session_, kernel_);
    state.conc().add_to(arguments, true);
    state.rates().add_to(arguments, writes_rates_);
    state.polarity().add_to(arguments, writes_polarity_);
    state.mappings().add_to(arguments, writes_mappings_);
    arguments.add(state.birth().now(), state.neighbours().now(), state.places(), state.fields().now(), parameters);
    const Grid& grid = state.grid();
    arguments.add(grid.columns, grid.rows, grid.pitch(), launch.vectors, launch.strip);
    arguments.add(static_cast<cl_uint>(first), launch.steps, launch.passes, static_cast<cl_uint>(seed_ & 0xffffffffu),
                  static_cast<cl_uint>(seed_ >> 32));
    add_more(arguments, launch, parameters);
    if (choice_.cut.batch) arguments.add(state.running_list());
}

void FusedStep::enqueue(LatticeState& state, const cl::Buffer& parameters, std::uint64_t first, std::uint64_t count,
                        Pace& pace) {
    while (count > 0) {
        const FusedLaunch launch = next_launch(state.grid(), count);
        set_arguments(state, parameters, launch, first);
        session_.launch(kernel_, cl::NDRange(launch.bands * choice_.cut.group, launch.strips, state.running()),
                        cl::NDRange(choice_.cut.group, 1, 1));
        pace.launched();
        if (launch.passes % 2 != 0) swap_planes(state);
        first += launch.steps * launch.passes;
        count -= launch.steps * launch.passes;
    }
}

}  // namespace pelage
