// See self_check.hpp.
#include "app/self_check.hpp"

#include "app/own_program.hpp"
#include "core/error.hpp"
#include "io/atomic_file.hpp"
#include "io/checksum.hpp"
#include "io/file_bytes.hpp"
#include "opencl/device/cache.hpp"
#include "opencl/device/kernel_sources.hpp"
#include "opencl/device/schedule.hpp"
#include "opencl/device/session.hpp"
#include "opencl/device/subnormal.hpp"
#include "verify/self_test.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <optional>

namespace pelage::app {

namespace {

const std::string note_mark = "\nnote: ";

// All that a passed test depends on.
std::string key_of(const OpenclOptions& options, const DeviceInfo& device, const Experiment& experiment,
                   const Snapshot& initial, std::uint64_t last) {
    const LatticeCut& cut = options.cut;
    return fmt::format(
        "pelage self-test passed\n{}\n{}\n{}\n{}\n{}\n{} {} {}\nkernel {} {} {} {} {} {} {}\n"
        "{} to {}, {} x {}, {} cells\n{}",
        device.name, device.version, device.driver, device.platform_version, own_checksum(),
        options.precision == Precision::double_ ? "double" : "float", options.fast ? "fast" : "exact",
        static_cast<int>(options.neighbours), static_cast<int>(options.path), options.width, options.work_group,
        cut.depth, cut.columns, cut.rows, cut.group, initial.iteration, last, initial.columns, initial.rows,
        initial.cells(), experiment.text);
}

std::filesystem::path file_of(const std::string& key) {
    Checksum sum;
    sum.add(key.data(), key.size());
    return cache_folder() / fmt::format("{:016x}.self-test", sum.value());
}

// The note that belongs to it.
std::optional<std::string> passed_before(const std::string& key) {
    if (cache_folder().empty()) return {};
    try {
        const std::string text = read_file(file_of(key));
        if (!text.starts_with(key + note_mark)) return {};
        return text.substr(key.size() + note_mark.size());
    } catch (const Error&) {
        return {};
    }
}

void remember(const std::string& key, const std::string& note) {
    if (cache_folder().empty()) return;
    try {
        std::error_code ignored;
        std::filesystem::create_directories(cache_folder(), ignored);
        write_file(file_of(key), key + note_mark + note);
    } catch (const Error&) {
        return;  // it will be tested again
    }
}

}  // namespace

SelfCheck self_check(const OpenclOptions& options, const DeviceInfo& device, const Experiment& experiment,
                     const Snapshot& initial, std::uint64_t last) {
    const std::string key = key_of(options, device, experiment, initial, last);
    const bool remembers = options.use_cache && kernels_folder().empty() && schedule().empty();
    if (remembers) {
        if (const auto note = passed_before(key)) return {"", *note};
    }
    const std::string difference = verify::self_test(options, experiment, initial, last);
    if (difference.empty()) {
        const std::string note = subnormal_difference(Session(device, options));
        if (remembers) remember(key, note);
        return {"", note};
    }
    return {fmt::format("device '{}' fails the self-test, its numbers are not the reference's: {}; `pelage verify "
                        "--device {}` tells more, --no-self-test runs all the same",
                        device.name, difference, device.index),
            ""};
}

}  // namespace pelage::app
