// See results.hpp.
#include "io/results.hpp"

#include "core/error.hpp"
#include "io/result_plan.hpp"
#include "io/shape.hpp"

#include <fmt/format.h>
#include <system_error>

namespace pelage {
namespace {

void check_outputs(const Experiment& experiment) {
    if (experiment.chemicals.empty()) throw Error("an experiment without chemicals has no results");
    for (const auto& output : experiment.outputs) {
        if (output.chemical >= experiment.chemicals.size()) {
            throw Error(
                fmt::format("an output names chemical {}; there are {}", output.chemical, experiment.chemicals.size()));
        }
    }
}

}  // namespace

std::vector<std::string> write_results(const std::filesystem::path& folder, const std::string& stem,
                                       const Snapshot& snapshot, const Experiment& experiment,
                                       const ResultOptions& options) {
    check_shape(snapshot, experiment);
    check_outputs(experiment);
    std::error_code code;
    std::filesystem::create_directories(folder, code);
    if (code) throw Error(fmt::format("cannot make the folder '{}': {}", folder.string(), code.message()));
    return ResultPlan(folder, stem, snapshot, experiment, options).write();
}

}  // namespace pelage
