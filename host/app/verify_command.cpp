// `pelage verify`: proves the kernels right, or wrong, on a device.
#include "app/commands.hpp"
#include "app/interrupt.hpp"
#include "app/named_files.hpp"
#include "app/prepare.hpp"
#include "app/progress.hpp"
#include "app/say.hpp"
#include "app/validators.hpp"
#include "app/verification.hpp"
#include "core/error.hpp"
#include "io/atomic_file.hpp"
#include "io/manifest.hpp"
#include "opencl/device/kernel_sources.hpp"
#include "opencl/device/schedule.hpp"
#include "verify/causes.hpp"
#include "verify/report.hpp"

#include <fmt/format.h>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace pelage::app {

namespace {

struct Request {
    VerifyOptions options;
    bool list = false;
    bool worker = false;
    bool quick = false;  // the default, said aloud
    std::filesystem::path json;
    std::filesystem::path page;
};

std::vector<DeviceInfo> devices_of(const VerifyOptions& options) {
    if (options.device != "all") {
        return {select_device(options.device.empty() ? std::nullopt : std::optional(options.device))};
    }
    std::vector<DeviceInfo> usable;
    for (const DeviceInfo& device : list_devices()) {
        if (device.unusable.empty()) usable.push_back(device);
    }
    if (usable.empty()) throw Error("there is no OpenCL device that can be used; `pelage devices` tells why");
    return usable;
}

void print_failures(const verify::DeviceReport& report, const VerifyOptions& options) {
    bool first = true;
    if (const std::string causes = verify::causes_text(report.results); !causes.empty()) say("\n{}\n", causes);
    for (const verify::Result& result : verify::failures(report.results)) {
        say("\n{}: {}\n", result.name, word(result.verdict));
        if (!result.first.empty()) say("  {}\n", result.first);
        if (!result.message.empty()) say("  {}\n", result.message);
        if (first) say("  alone: {}\n", reproduce_command(options, report.device, result.name));
        if (first && !result.files.empty()) {
            say("  pictures of reference, device and difference: {}\n",
                (result.files.front().parent_path() / "").string());
        }
        first = false;
    }
    for (const verify::Result& result : report.results) {
        if (result.verdict == verify::Verdict::skipped) say("\n{}: skipped: {}\n", result.name, result.message);
    }
}

void print_summary(const verify::Report& report) {
    const verify::Summary sum = total(report);
    say("\n");
    for (const std::string& one : conditions(report)) say("{}.\n", one);
    for (const verify::DeviceReport& device : report.devices) {
        const std::string causes = verify::causes_text(device.results);
        if (!causes.empty()) say("{}\n", causes);
    }
    say("{}: {} of {} passed, {} failed, {} mistrusted, {} skipped; {} compared, {}; {:.1f} s\n",
        verify::verdict_word(report), sum.passed, counted(sum.cases + report.left_out, "case"), sum.failed,
        sum.mistrusted, sum.skipped, counted(sum.cells_compared, "cell"),
        counted(sum.cells_differing, "differs", "differ"), report.seconds);
}

void print_comparison(const verify::Report& report) {
    const std::vector<std::string> lines = unlike(report);
    if (lines.empty()) {
        say("\nAll {} devices gave the same bits in every case that they share.\n", report.devices.size());
        return;
    }
    say("\nCases in which devices differ from each other (a sum over all they gave, and their indices):\n");
    for (const std::string& line : lines) say("  {}\n", line);
}

int list(const VerifyOptions& options) {
    for (const verify::Check& check : selected(options)) say("{:<20} {}\n", check.kernel, check.name);
    return success;
}

int verify_all(const Request& request) {
    const VerifyOptions& options = request.options;
    if (request.quick && options.full) throw Error("--quick and --full exclude each other");
    if (request.worker) return answer_checks(options);
    if (request.list) return list(options);
    if (!options.evidence.empty()) try_folder(options.evidence);
    prepare_json(request.json);
    prepare_json(request.page);
    keep_inputs("--html", request.page, {request.json}, "the file of --json");
    const auto start = std::chrono::steady_clock::now();
    const std::vector<verify::Check> checks = selected(options);
    verify::Report report;
    report.version = PELAGE_VERSION;
    report.date = iso_time(std::chrono::system_clock::now());
    report.seed = options.seed;
    report.form = options.full ? "full" : "quick";
    report.kernels = kernels_folder();
    report.schedule = schedule();
    const Interrupt interrupt;
    for (const DeviceInfo& device : devices_of(options)) {
        if (!device.unusable.empty()) throw Error(fmt::format("device '{}': {}", device.name, device.unusable));
        say("{}{} ({}, driver {})\n", report.devices.empty() ? "" : "\n", device.name, device.platform, device.driver);
        send();
        report.devices.push_back(verify_device(device, checks, options));
        report.left_out += checks.size() - report.devices.back().results.size();
        say("{}", table(report.devices.back().results));
        print_failures(report.devices.back(), options);
    }
    report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (report.devices.size() > 1) print_comparison(report);
    print_summary(report);
    const auto replace = nlohmann::ordered_json::error_handler_t::replace;  // a driver may not speak UTF-8
    if (!request.json.empty()) write_file(request.json, to_json(report).dump(2, ' ', false, replace) + "\n");
    if (!request.page.empty()) write_file(request.page, html(report));
    if (Interrupt::came()) return interrupted;
    const verify::Summary sum = total(report);
    return sum.failed + sum.mistrusted == 0 ? success : failed_check;
}

}  // namespace

void add_verify(CLI::App& app, int& exit_code) {
    const auto request = std::make_shared<Request>();
    VerifyOptions& options = request->options;
    CLI::App* command =
        app.add_subcommand("verify", "Check every kernel on a device against the reference, bit by bit");
    command->add_option("--device", options.device, "Index or part of the name, or `all`; see `pelage devices`")
        ->type_name("DEVICE");
    command->add_flag("--quick", request->quick, "Each kernel path once, in half a minute to a few (default)");
    command->add_flag("--full", options.full, "Every case, in every shape of the work, in some minutes");
    command->add_flag("--small", options.small, "Smallest sizes alone, for simulators");
    command->add_option("--filter", options.filter, "Only checks with this in their name")->type_name("TEXT");
    command->add_option("--seed", options.seed, "For the checks that are drawn at random. Default: 1")
        ->type_name("N")
        ->transform(whole_number(0, std::numeric_limits<std::uint64_t>::max()));
    command->add_option("--jobs", options.jobs, "Processes at once (default: as many as processors, at most 8)")
        ->type_name("N")
        ->transform(whole_number(1, 64));
    command->add_option("--limit", options.limit, "Seconds that one check may take. Default: 300")
        ->type_name("SECONDS")
        ->transform(whole_number(1, 86'400));
    command
        ->add_option("--evidence", options.evidence,
                     "Folder for pictures of differences, made when needed. Default: pelage-verify")
        ->type_name("DIR");
    command->add_option("--json", request->json, "Write all results to this file")->type_name("FILE");
    command->add_option("--html", request->page, "Write a page to look at")->type_name("FILE");
    command->add_flag("--list", request->list, "Name the checks and run none");
    command->add_flag("--quiet", options.quiet, "No progress");
    command->add_flag("--worker", request->worker)->group("");
    command->callback([request, &app, &exit_code] {
        request->options.command = app.get_name();
        exit_code = verify_all(*request);
    });
}

}  // namespace pelage::app
