// See device.hpp: which of the devices is taken.
#include "core/error.hpp"
#include "opencl/device/device.hpp"
#include "opencl/device/spelling.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cstdlib>
#include <system_error>

namespace pelage {

namespace {

std::string listing(const std::vector<DeviceInfo>& devices) {
    if (devices.empty()) return why_no_devices();
    std::string text = "devices here:";
    for (const DeviceInfo& device : devices) {
        text += fmt::format("\n  {}: {} ({}, {}){}{}", device.index, device.name, device.type, device.platform,
                            device.unusable.empty() ? "" : ", cannot be used: ", device.unusable);
    }
    return text;
}

bool is_type(const std::string& word) { return word == "gpu" || word == "cpu" || word == "accelerator"; }

// Lower is better.
int rank(const DeviceInfo& device) {
    if (device.software_rasteriser()) return 4;
    if (device.type == "gpu") return 0;
    if (device.type == "cpu") return 1;
    return device.type == "accelerator" ? 2 : 3;
}

// The best-ranked usable device that `fits`; devices.size() when there is none.
template <class Fits>
std::size_t best(const std::vector<DeviceInfo>& devices, Fits fits) {
    std::size_t found = devices.size();
    for (std::size_t i = 0; i < devices.size(); ++i) {
        if (!devices[i].unusable.empty() || !fits(devices[i])) continue;
        if (found == devices.size() || rank(devices[i]) < rank(devices[found])) found = i;
    }
    return found;
}

std::optional<std::size_t> as_index(const std::string& word) {
    std::size_t index = 0;
    const auto [end, failure] = std::from_chars(word.data(), word.data() + word.size(), index);
    if (failure != std::errc{} || end != word.data() + word.size()) return {};
    return index;
}

std::size_t by_index(const std::vector<DeviceInfo>& devices, std::size_t index) {
    if (index >= devices.size()) throw Error(fmt::format("there is no OpenCL device {}; {}", index, listing(devices)));
    if (!devices[index].unusable.empty()) {
        throw Error(fmt::format("OpenCL device {} ({}) cannot be used: {}", index, devices[index].name,
                                devices[index].unusable));
    }
    return index;
}

}  // namespace

std::size_t choose_device(const std::vector<DeviceInfo>& devices, const std::optional<std::string>& wanted) {
    const std::string word = lower(trimmed(wanted.value_or("")));
    if (const auto index = as_index(word)) return by_index(devices, *index);
    const auto fits = [&](const DeviceInfo& device) {
        if (word.empty()) return true;
        return is_type(word) ? device.type == word : lower(device.name).find(word) != std::string::npos;
    };
    // "pocl" is in the version alone: that platform calls itself Portable Computing Language.
    const auto stands_on = [&](const DeviceInfo& device) {
        return lower(device.platform + "\n" + device.platform_version).find(word) != std::string::npos;
    };
    std::size_t found = best(devices, fits);
    if (found == devices.size() && !word.empty() && !is_type(word)) found = best(devices, stands_on);
    if (found < devices.size()) return found;
    if (devices.empty() && word.empty()) throw Error(listing(devices));
    if (word.empty()) throw Error("no usable OpenCL device; " + listing(devices));
    throw Error(fmt::format("no usable OpenCL device or platform is, or is named, '{}'; {}", word, listing(devices)));
}

DeviceInfo select_device(const std::optional<std::string>& wanted) {
    const std::vector<DeviceInfo> devices = list_devices();
    const char* variable = std::getenv("PELAGE_DEVICE");
    if (wanted || variable == nullptr || *variable == '\0') return devices.at(choose_device(devices, wanted));
    try {
        return devices.at(choose_device(devices, variable));
    } catch (const Error& error) {
        throw Error(fmt::format("the environment variable PELAGE_DEVICE asks for '{}': {}", variable, error.what()));
    }
}

}  // namespace pelage
