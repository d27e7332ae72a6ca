// See fused_step.hpp.
#include "opencl/fused_step.hpp"

#include "core/counted.hpp"

#include "opencl/emit_lattice.hpp"

#include <fmt/format.h>

namespace pelage {

FusedStep::FusedStep(const Session& session, const Experiment& experiment, const LatticePlan& plan,
                     const std::vector<bool>& active, bool test_intervals, bool tiled)
    : session_(session),
      width_(lattice_width(session)),
      seed_(static_cast<std::uint64_t>(experiment.run_seed())),
      tiled_(tiled),
      shared_(session) {
    const RuleText rules = emit_rules(experiment, active, session.options().precision, test_intervals);
    writes_rates_ = !rules.use.rates_written.empty();
    writes_polarity_ = !rules.use.polarizes.empty();
    writes_mappings_ = !rules.use.mappings_written.empty();
    const FusedFields fields = fused_fields(experiment, plan, rules.use);
    shape_ = tiled ? tile_shape(session, fields, width_) : stream_shape(session, fields, width_);
    const auto source = tiled ? tile_source : stream_source;
    const cl::Program program = session.build(
        source(experiment, plan, rules, bounded_chemicals(experiment), session.options().precision, width_, shape_));
    kernel_ = cl::Kernel(program, tiled ? "pelage_lattice_tile" : "pelage_lattice_stream");
}

std::string FusedStep::describe() const {
    return fmt::format("fused, {}, up to {} in one pass over memory", tiled_ ? "in tiles of local memory" : "streamed",
                       counted(shape_.depth, "iteration"));
}

void FusedStep::set_planes(LatticeState& state) {
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

void FusedStep::swap_planes(LatticeState& state) const {
    state.conc().swap();
    if (writes_rates_) state.rates().swap();
    if (writes_polarity_) state.polarity().swap();
    if (writes_mappings_) state.mappings().swap();
}

// `none`: any buffer, where nothing is shared.
void FusedStep::set_sharing(const cl::Buffer& none, const FusedLaunch& launch) {
    if (launch.together) {
        shared_.prepare(kernel_, 23, launch.strips, launch.passes);
        return;
    }
    kernel_.setArg(23, none);
    kernel_.setArg(24, cl_int{0});
    kernel_.setArg(25, cl_int{0});
    kernel_.setArg(26, cl_int{0});
}

void FusedStep::enqueue(LatticeState& state, const cl::Buffer& parameters, std::uint64_t first, std::uint64_t count,
                        Pace& pace) {
    while (count > 0) {
        const FusedLaunch launch = tiled_ ? tile_launch(state.grid(), shape_, width_, count)
                                          : stream_launch(session_.info(), state.grid(), shape_, width_, count);
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
        if (!tiled_) kernel_.setArg(22, static_cast<cl_int>(launch.margin));
        if (shape_.together) set_sharing(parameters, launch);
        session_.launch(kernel_, cl::NDRange(launch.bands * shape_.group, launch.strips), cl::NDRange(shape_.group, 1));
        pace.launched();
        if (launch.passes % 2 != 0) swap_planes(state);
        first += launch.steps * launch.passes;
        count -= launch.steps * launch.passes;
    }
}

}  // namespace pelage
