// See report.hpp: the report for programs.
#include "bench/report.hpp"

#include <nlohmann/json.hpp>

#include <vector>

namespace pelage::bench {

namespace {

using Json = nlohmann::ordered_json;

Json entry(const Yardstick& one) {
    return {{"device", one.device},
            {"driver", one.driver},
            {"platform", one.platform},
            {"threads", one.threads},
            {"copy_bandwidth", one.copy_bandwidth},
            {"copy_bytes", one.copy_bytes},
            {"peak", one.peak}};
}

Json entry(const Result& one) {
    return {{"suite", one.suite},
            {"case", one.name},
            {"size", one.size},
            {"backend", one.backend},
            {"device", one.device},
            {"cells", one.cells},
            {"iterations", one.iterations},
            {"seconds", one.seconds},
            {"best", one.best},
            {"spread", one.spread},
            {"updates_per_second", one.updates_per_second},
            {"bytes_per_second", one.bytes_per_second},
            {"copy_bandwidth", one.copy_bandwidth},
            {"bandwidth_share", one.bandwidth_share},
            {"arithmetic_share", one.arithmetic_share},
            {"bytes_per_update", one.bytes_per_update},
            {"flops_per_update", one.flops_per_update},
            {"bytes_per_cell", one.bytes_per_cell > 0 ? Json(one.bytes_per_cell) : Json()},
            {"largest_difference", one.largest_difference}};
}

Json entry(const Ratio& one) {
    return {{"suite", one.suite},     {"case", one.name},     {"size", one.size},  {"backend", one.backend},
            {"against", one.against}, {"device", one.device}, {"ratio", one.ratio}};
}

Json entry(const Note& one) {
    return {{"suite", one.suite},   {"case", one.name},   {"size", one.size}, {"backend", one.backend},
            {"device", one.device}, {"wrong", one.wrong}, {"text", one.text}};
}

template <class T>
Json entries(const std::vector<T>& list) {
    Json all = Json::array();
    for (const T& one : list) all.push_back(entry(one));
    return all;
}

}  // namespace

Json json_of(const Report& report, const Options& options, bool complete) {
    const Yardstick& device = report.yardsticks.size() > 1 ? report.yardsticks[1] : report.yardsticks[0];
    return {{"version", PELAGE_VERSION},
            {"device", device.device},
            {"driver", device.driver},
            {"copy_bandwidth", device.copy_bandwidth},
            {"peak", device.peak},
            {"runs", options.runs},
            {"quick", options.quick},
            {"load", report.load},
            {"complete", complete},
            {"devices", entries(report.yardsticks)},
            {"results", entries(report.results)},
            {"ratios", entries(ratios(report))},
            {"notes", entries(report.notes)}};
}

}  // namespace pelage::bench
