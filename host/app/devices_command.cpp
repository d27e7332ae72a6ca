// `pelage devices`: the OpenCL devices of this machine, and what each can do.
#include "app/commands.hpp"
#include "app/memory.hpp"
#include "app/prepare.hpp"
#include "app/say.hpp"
#include "app/text_table.hpp"
#include "io/atomic_file.hpp"
#include "opencl/device/device.hpp"

#include <fmt/format.h>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace pelage::app {

namespace {

TableLine heading() {
    return {"INDEX", "PLATFORM", "DEVICE", "VERSION", "DRIVER", "MEMORY", "FP64", "EXACT DIVISION", "USABLE"};
}

std::string yes_no(bool yes) { return yes ? "yes" : "no"; }

TableLine line_of(const DeviceInfo& device) {
    return {std::to_string(device.index),
            device.platform,
            fmt::format("{} ({})", device.name, device.type),
            device.version,
            device.driver,
            readable_bytes(static_cast<double>(device.memory)),
            yes_no(device.fp64),
            yes_no(device.correctly_rounded_divide_sqrt),
            device.unusable.empty() ? "yes" : "no: " + device.unusable};
}

void print_table(const std::vector<DeviceInfo>& devices) {
    std::vector<TableLine> lines{heading()};
    for (const DeviceInfo& device : devices) lines.push_back(line_of(device));
    say("{}", aligned(lines));
}

nlohmann::ordered_json json_of(const std::vector<DeviceInfo>& devices) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const DeviceInfo& device : devices) {
        list.push_back({{"index", device.index},
                        {"platform", device.platform},
                        {"platform_version", device.platform_version},
                        {"device", device.name},
                        {"vendor", device.vendor},
                        {"type", device.type},
                        {"version", device.version},
                        {"driver", device.driver},
                        {"memory", device.memory},
                        {"compute_units", device.compute_units},
                        {"fp64", device.fp64},
                        {"correctly_rounded_division", device.correctly_rounded_divide_sqrt},
                        {"usable", device.unusable.empty()},
                        {"reason", device.unusable}});
    }
    return {{"devices", list}};
}

int list(const std::filesystem::path& json) {
    const std::vector<DeviceInfo> devices = list_devices();
    if (devices.empty()) {
        std::string reason = why_no_devices();
        reason.front() = 'N';
        say("{}; experiments run on the reference.\n", reason);
    } else {
        print_table(devices);
    }
    if (!json.empty()) {
        prepare_json(json);
        const auto replace = nlohmann::ordered_json::error_handler_t::replace;  // a driver may not speak UTF-8
        write_file(json, json_of(devices).dump(2, ' ', false, replace) + "\n");
    }
    return success;
}

}  // namespace

void add_devices(CLI::App& app, int& exit_code) {
    const auto json = std::make_shared<std::filesystem::path>();
    CLI::App* command = app.add_subcommand("devices", "List the OpenCL devices, and why one cannot be used");
    command->add_option("--json", *json, "Write the list to this file too")->type_name("FILE");
    command->callback([json, &exit_code] { exit_code = list(*json); });
}

}  // namespace pelage::app
