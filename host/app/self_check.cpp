// See self_check.hpp.
#include "app/self_check.hpp"

#include "app/own_program.hpp"
#include "core/error.hpp"
#include "io/atomic_file.hpp"
#include "io/checksum.hpp"
#include "io/file_bytes.hpp"
#include "opencl/cache.hpp"
#include "verify/self_test.hpp"

#include <fmt/format.h>

#include <filesystem>

namespace pelage::app {

namespace {

// All that a passed test depends on.
std::string key_of(const OpenclOptions& options, const DeviceInfo& device, const Experiment& experiment,
                   const Snapshot& initial, std::uint64_t last) {
    const LatticeCut& cut = options.cut;
    return fmt::format(
        "pelage self-test passed\n{}\n{}\n{}\n{}\n{}\n{} {} {}\nkernel {} {} {} {} {} {} {}\n"
        "{} to {}, {} x {}, {} cells\n{}",
        device.name, device.version, device.driver, device.platform_version, own_checksum(),
        options.precision == Precision::double_ ? "double" : "float", options.fast ? "fast" : "exact",
        static_cast<int>(options.neighbours), static_cast<int>(options.fusion), options.width, options.work_group,
        cut.depth, cut.columns, cut.rows, cut.group, initial.iteration, last, initial.columns, initial.rows,
        initial.cells(), experiment.text);
}

std::filesystem::path file_of(const std::string& key) {
    Checksum sum;
    sum.add(key.data(), key.size());
    return cache_folder() / fmt::format("{:016x}.self-test", sum.value());
}

bool passed_before(const std::string& key) {
    if (cache_folder().empty()) return false;
    try {
        return read_file(file_of(key)) == key;
    } catch (const Error&) {
        return false;
    }
}

void remember(const std::string& key) {
    if (cache_folder().empty()) return;
    try {
        std::error_code ignored;
        std::filesystem::create_directories(cache_folder(), ignored);
        write_file(file_of(key), key);
    } catch (const Error&) {
        return;  // it will be tested again
    }
}

}  // namespace

std::string self_check(const OpenclOptions& options, const DeviceInfo& device, const Experiment& experiment,
                       const Snapshot& initial, std::uint64_t last) {
    const std::string key = key_of(options, device, experiment, initial, last);
    if (options.use_cache && passed_before(key)) return {};
    const std::string difference = verify::self_test(options, experiment, initial, last);
    if (difference.empty()) {
        if (options.use_cache) remember(key);
        return {};
    }
    return fmt::format(
        "device '{}' fails the self-test, its numbers are not the reference's: {}; `pelage verify --device {}` tells "
        "more, --no-self-test runs all the same",
        device.name, difference, device.index);
}

}  // namespace pelage::app
