// See report_read.hpp.
#include "bench/report_read.hpp"

#include "core/error.hpp"
#include "io/file_bytes.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace pelage::bench {

namespace {

using nlohmann::json;

Yardstick yardstick_of(const json& one) {
    Yardstick made;
    made.device = one.at("device");
    made.driver = one.at("driver");
    made.platform = one.at("platform");
    made.threads = one.at("threads");
    made.copy_bandwidth = one.at("copy_bandwidth");
    made.copy_bytes = one.at("copy_bytes");
    made.peak = one.at("peak");
    return made;
}

Result result_of(const json& one) {
    Result made;
    made.suite = one.at("suite");
    made.name = one.at("case");
    made.size = one.at("size");
    made.backend = one.at("backend");
    made.device = one.at("device");
    made.cells = one.at("cells");
    made.iterations = one.at("iterations");
    made.seconds = one.at("seconds");
    made.best = one.at("best");
    made.spread = one.at("spread");
    made.updates_per_second = one.at("updates_per_second");
    made.bytes_per_second = one.at("bytes_per_second");
    made.copy_bandwidth = one.at("copy_bandwidth");
    made.bandwidth_share = one.at("bandwidth_share");
    made.arithmetic_share = one.at("arithmetic_share");
    made.bytes_per_update = one.at("bytes_per_update");
    made.flops_per_update = one.at("flops_per_update");
    made.bytes_per_cell = one.at("bytes_per_cell").is_null() ? 0.0 : one.at("bytes_per_cell").get<double>();
    made.largest_difference = one.at("largest_difference");
    return made;
}

Note note_of(const json& one) {
    return {one.at("suite"),  one.at("case"), one.at("size"), one.at("backend"),
            one.at("device"), one.at("text"), one.at("wrong")};
}

}  // namespace

Report read_report(const std::filesystem::path& file) {
    const std::string text = read_file(file);
    try {
        const json whole = json::parse(text);
        Report report;
        for (const json& one : whole.at("devices")) report.yardsticks.push_back(yardstick_of(one));
        for (const json& one : whole.at("results")) report.results.push_back(result_of(one));
        for (const json& one : whole.at("notes")) report.notes.push_back(note_of(one));
        report.load = whole.at("load");
        if (report.yardsticks.empty()) throw Error(fmt::format("'{}' names no device", file.string()));
        return report;
    } catch (const json::exception& error) {
        throw Error(fmt::format("'{}' is not what `pelage bench --json` writes: {}", file.string(), error.what()));
    }
}

}  // namespace pelage::bench
