// See tissue.hpp.
#include "opencl/volume/tissue.hpp"

#include "opencl/lattice/tissue.hpp"
#include "opencl/volume/step.hpp"

#include <utility>

namespace pelage {

std::unique_ptr<Tissue> make_opencl_volume(std::shared_ptr<const Session> session,
                                           std::shared_ptr<const Experiment> experiment, const Snapshot& initial) {
    const auto make_step = [](const Session& device, const Experiment& whole, const LatticePlan& plan,
                              const std::vector<bool>& active, bool test_intervals, const Choice& choice) {
        return std::make_unique<VolumeStep>(device, whole, plan, active, test_intervals, choice);
    };
    return make_opencl_lattice(std::move(session), std::move(experiment), initial, make_step);
}

}  // namespace pelage
