// See stream.hpp.
#include "opencl/lattice/stream.hpp"

#include <utility>

namespace pelage {

StreamedStep::StreamedStep(const Session& session, const Experiment& experiment, const LatticePlan& plan,
                           const std::vector<bool>& active, bool test_intervals, Choice choice)
    : FusedStep(session, experiment, plan, active, test_intervals, std::move(choice), stream_source,
                "pelage_lattice_stream"),
      shared_(session) {}

FusedLaunch StreamedStep::next_launch(const Grid& grid, std::uint64_t count) const {
    return stream_launch(session().info(), grid, choice().cut, choice().width, count);
}

void StreamedStep::add_more(Arguments& arguments, const FusedLaunch& launch, const cl::Buffer& parameters) {
    arguments.add(launch.margin);
    if (!choice().cut.together) return;
    if (launch.together) {
        shared_.prepare(arguments, launch.strips, launch.passes);
    } else {
        arguments.add(parameters, cl_int{0}, cl_int{0}, cl_int{0});  // any buffer: nothing is shared
    }
}

}  // namespace pelage
