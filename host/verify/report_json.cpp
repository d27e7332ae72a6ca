// See report.hpp: the report as JSON, and results as they travel between processes.
#include "verify/report.hpp"

#include "verify/causes.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <stdexcept>

namespace pelage::verify {

namespace {

using Json = nlohmann::ordered_json;

// JSON has no infinity.
Json json_number(double value) { return std::isfinite(value) ? Json(value) : Json("infinite"); }
double read_number(const Json& value) { return value.is_number() ? value.get<double>() : HUGE_VAL; }

Verdict verdict_of(const std::string& text) {
    for (const Verdict verdict : {Verdict::passed, Verdict::failed, Verdict::mistrusted, Verdict::skipped}) {
        if (text == word(verdict)) return verdict;
    }
    throw std::invalid_argument("no verdict: " + text);
}

Json to_json(const Summary& sum) {
    return {{"cases", sum.cases},
            {"passed", sum.passed},
            {"failed", sum.failed},
            {"mistrusted", sum.mistrusted},
            {"skipped", sum.skipped},
            {"cells_compared", sum.cells_compared},
            {"cells_differing", sum.cells_differing},
            {"max_ulp", sum.max_ulp},
            {"max_absolute", json_number(sum.max_absolute)},
            {"max_relative", json_number(sum.max_relative)},
            {"verdict", word(sum.verdict())}};
}

Json to_json(const DeviceReport& report) {
    const DeviceInfo& device = report.device;
    Json cases = Json::array();
    for (const Result& result : report.results) cases.push_back(to_json(result));
    Json kernels = Json::array();
    for (const Summary& sum : by_kernel(report.results)) {
        Json row = to_json(sum);
        row["kernel"] = sum.kernel;
        kernels.push_back(row);
    }
    return {{"device", device.name},
            {"index", device.index},
            {"type", device.type},
            {"vendor", device.vendor},
            {"opencl", device.version},
            {"driver", device.driver},
            {"platform", device.platform},
            {"platform_version", device.platform_version},
            {"fp64", device.fp64},
            {"correctly_rounded_division", device.correctly_rounded_divide_sqrt},
            {"build_options", report.build_options},
            {"summary", to_json(total(report.results))},
            {"likely_at_fault", likely_roots(report.results)},
            {"kernels", kernels},
            {"cases", cases}};
}

}  // namespace

Json to_json(const Result& result) {
    Json files = Json::array();
    for (const auto& file : result.files) files.push_back(file.string());
    return {{"name", result.name},
            {"kernel", result.kernel},
            {"verdict", word(result.verdict)},
            {"message", result.message},
            {"broken_off", result.broken_off},
            {"first_difference", result.first},
            {"cells_compared", result.cells_compared},
            {"cells_differing", result.cells_differing},
            {"max_ulp", result.max_ulp},
            {"max_absolute", json_number(result.max_absolute)},
            {"max_relative", json_number(result.max_relative)},
            {"fingerprint", result.fingerprint},
            {"seconds", result.seconds},
            {"files", files}};
}

Result result_from_json(const Json& json) {
    Result result;
    result.name = json.at("name");
    result.kernel = json.at("kernel");
    result.verdict = verdict_of(json.at("verdict"));
    result.message = json.at("message");
    result.broken_off = json.at("broken_off");
    result.first = json.at("first_difference");
    result.cells_compared = json.at("cells_compared");
    result.cells_differing = json.at("cells_differing");
    result.max_ulp = json.at("max_ulp");
    result.max_absolute = read_number(json.at("max_absolute"));
    result.max_relative = read_number(json.at("max_relative"));
    result.fingerprint = json.at("fingerprint");
    result.seconds = json.at("seconds");
    for (const Json& file : json.at("files")) result.files.emplace_back(file.get<std::string>());
    return result;
}

// One device: its data stand at the top level. Several: one object each below "devices", all cases together besides.
Json to_json(const Report& report) {
    Json json{{"program", "pelage"}, {"version", report.version}, {"date", report.date},
              {"seed", report.seed}, {"form", report.form},       {"seconds", report.seconds}};
    if (!report.kernels.empty()) json["kernels_folder"] = report.kernels;
    if (!report.schedule.empty()) json["schedule"] = report.schedule;
    json["left_out"] = report.left_out;
    if (report.devices.size() == 1) {
        json.update(to_json(report.devices.front()));
        json["summary"]["verdict"] = verdict_word(report);
        return json;
    }
    json["summary"] = to_json(total(report));
    json["summary"]["verdict"] = verdict_word(report);
    json["unlike"] = unlike(report);
    json["devices"] = Json::array();
    for (const DeviceReport& device : report.devices) json["devices"].push_back(to_json(device));
    json["cases"] = Json::array();
    for (const DeviceReport& device : report.devices) {
        for (const Result& result : device.results) {
            Json row = to_json(result);
            row["device"] = device.device.index;
            json["cases"].push_back(row);
        }
    }
    return json;
}

}  // namespace pelage::verify
