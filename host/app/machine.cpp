// See machine.hpp.
#include "app/machine.hpp"

#include "bench/yardstick.hpp"
#include "core/error.hpp"
#include "opencl/backend.hpp"
#include "reference/backend.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

namespace pelage::app {

namespace {

Machine on_reference(const RunOptions& options, const Experiment& experiment) {
    check_device(options.backend, options.device);
    if (options.fast) throw Error("--fast changes only how OpenCL computes; it goes with --backend opencl");
    Machine machine{reference_backend(options.precision, options.neighbour_search(), options.sorting),
                    "reference",
                    {},
                    bench::processor_name(),
                    __VERSION__,
                    "C++",
                    "-ffp-contract=off",
                    {},
                    {},
                    {}};
    const std::string reason = machine.backend->why_not(experiment);
    if (!reason.empty()) throw Error(fmt::format("the reference cannot run this experiment: {}", reason));
    return machine;
}

bool by_variable(const RunOptions& options) { return options.device.empty() && variable_chooses_device(); }

Machine on_opencl(const RunOptions& options, const Experiment& experiment, const Footprint& footprint) {
    OpenclOptions wanted;
    if (!options.device.empty()) wanted.device = options.device;
    wanted.precision = options.precision;
    wanted.use_cache = !options.no_cache;
    wanted.fast = options.fast;
    wanted.neighbours = options.neighbour_search();
    wanted.sorting = options.sorting;
    std::unique_ptr<OpenclBackend> backend = opencl_backend(wanted);
    const DeviceInfo device = backend->device();
    std::string reason = backend->why_not(experiment);
    if (reason.empty()) reason = why_not_on_device(footprint, static_cast<double>(device.memory));
    if (!reason.empty()) {
        const char* asked = by_variable(options) ? " (the environment variable PELAGE_DEVICE asks for it)" : "";
        throw Error(fmt::format("device '{}'{} cannot run this experiment: {}", device.name, asked, reason));
    }
    std::string build_options = backend->build_options();
    wanted.device = std::to_string(device.index);
    return {std::move(backend),       "opencl", {},     device.name, device.driver, device.platform,
            std::move(build_options), wanted,   device, {}};
}

}  // namespace

void check_device(const std::string& backend, const std::string& device) {
    if (backend == "reference" && !device.empty())
        throw Error("--device chooses an OpenCL device; it goes with --backend opencl");
}

bool variable_chooses_device() {
    const char* variable = std::getenv("PELAGE_DEVICE");
    return variable != nullptr && *variable != '\0';
}

Worked worked(const Machine& machine) {
    if (!machine.opencl) return Worked::by_reference;
    return machine.info.type == "cpu" ? Worked::in_main_memory : Worked::on_a_card;
}

Machine choose_machine(const RunOptions& options, const Experiment& experiment, const Footprint& footprint) {
    if (options.backend == "reference") return on_reference(options, experiment);
    if (options.backend == "opencl" || !options.device.empty() || by_variable(options) || options.fast) {
        return on_opencl(options, experiment, footprint);
    }
    try {
        return on_opencl(options, experiment, footprint);
    } catch (const Error& error) {
        Machine machine = on_reference(options, experiment);
        machine.why = error.what();
        return machine;
    }
}

}  // namespace pelage::app
