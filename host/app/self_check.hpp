// The self-test that comes before every run on OpenCL, and the memory of those that were passed.
#pragma once

#include "app/run_options.hpp"
#include "core/experiment.hpp"
#include "core/snapshot.hpp"
#include "opencl/device/device.hpp"
#include "opencl/device/options.hpp"

#include <cstdint>
#include <string>

namespace pelage::app {

struct SelfCheck {
    std::string fault;  // empty: passed, now or earlier under the same device, driver, program and experiment;
                        // otherwise one sentence that names what is wrong and `pelage verify`
    std::string note;   // of a passed one: how far results are equal on a device that keeps subnormal numbers
};

SelfCheck self_check(const OpenclOptions&, const DeviceInfo&, const Experiment&, const Snapshot& initial,
                     std::uint64_t last);

}  // namespace pelage::app
