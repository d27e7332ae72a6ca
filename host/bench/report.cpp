// See report.hpp.
#include "bench/report.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace pelage::bench {

namespace {

using Line = std::vector<std::string>;

// First columns to the left, numbers to the right.
std::string aligned(const std::vector<Line>& lines, std::size_t words) {
    std::vector<std::size_t> widths(lines.front().size(), 0);
    for (const Line& line : lines) {
        for (std::size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], line[i].size());
    }
    std::string text;
    for (const Line& line : lines) {
        std::string row;
        for (std::size_t i = 0; i < line.size(); ++i) {
            row +=
                i < words ? fmt::format("{:<{}}  ", line[i], widths[i]) : fmt::format("{:>{}}  ", line[i], widths[i]);
        }
        row.erase(row.find_last_not_of(' ') + 1);
        text += row + "\n";
    }
    return text;
}

std::string millions(double value) {
    return fmt::format("{:.{}f}", value / 1e6, value < 1e7 ? 2 : value < 1e8 ? 1 : 0);
}

std::string yardstick_table(const Report& report) {
    std::vector<Line> lines{{"DEVICE", "DRIVER", "THREADS", "COPY GB/s", "PEAK GFLOP/s"}};
    for (const Yardstick& one : report.yardsticks) {
        lines.push_back({one.device, one.platform + " " + one.driver, std::to_string(one.threads),
                         fmt::format("{:.1f}", one.copy_bandwidth / 1e9), fmt::format("{:.0f}", one.peak / 1e9)});
    }
    return aligned(lines, 2);
}

std::string result_table(const Report& report) {
    std::vector<Line> lines{{"SUITE", "CASE", "SIZE", "BACKEND", "CELLS", "ITERATIONS", "SECONDS", "SPREAD",
                             "M UPDATES/s", "GB/s", "OF COPY", "OF PEAK"}};
    for (const Result& one : report.results) {
        lines.push_back({one.suite, one.name, std::to_string(one.size), one.backend, std::to_string(one.cells),
                         std::to_string(one.iterations), fmt::format("{:.4g}", one.seconds),
                         fmt::format("{:.0f} %", 100 * one.spread), millions(one.updates_per_second),
                         fmt::format("{:.1f}", one.bytes_per_second / 1e9), fmt::format("{:.2f}", one.bandwidth_share),
                         fmt::format("{:.2f}", one.arithmetic_share)});
    }
    return aligned(lines, 4);
}

std::string ratio_table(const std::vector<Ratio>& list) {
    std::vector<Line> lines{{"SUITE", "CASE", "SIZE", "BACKEND", "AGAINST", "TIMES FASTER"}};
    for (const Ratio& one : list) {
        lines.push_back({one.suite, one.name, std::to_string(one.size), one.backend, one.against,
                         fmt::format("{:.{}f}", one.ratio, one.ratio < 10 ? 2 : 0)});
    }
    return aligned(lines, 5);
}

std::string note_lines(const Report& report) {
    std::string text;
    if (report.load > 0.3) {
        text +=
            fmt::format("The machine was busy with other things (load {:.1f}): figures are disturbed.\n", report.load);
    }
    for (const Note& note : report.notes) {
        text += fmt::format("{}{} {} {}, {}: {}\n", note.wrong ? "WRONG, not timed: " : "left out: ", note.suite,
                            note.name, note.size, note.backend, note.text);
    }
    return text;
}

double best_rate(const Result& one) { return one.updates_per_second * one.seconds / one.best; }

}  // namespace

std::vector<Ratio> ratios(const Report& report) {
    std::vector<Ratio> list;
    for (const Result& ours : report.results) {
        if (ours.backend != "opencl") continue;
        const auto add = [&](const std::string& against, double ratio) {
            list.push_back({ours.suite, ours.name, ours.size, ours.backend, against, ours.device, ratio});
        };
        for (const Result& other : report.results) {
            const bool same = other.suite == ours.suite && other.name == ours.name && other.size == ours.size;
            const bool host = other.backend.rfind("opencl", 0) != 0;
            if (!same || other.backend == "opencl" || (!host && other.device != ours.device)) continue;
            add(other.backend, best_rate(ours) / best_rate(other));
        }
        if (ours.suite == "lattice" && ours.bandwidth_share > 0) add("copy", ours.bandwidth_share);
    }
    return list;
}

std::string tables(const Report& report) {
    std::string text = yardstick_table(report);
    if (!report.results.empty()) text.append("\n").append(result_table(report));
    const std::vector<Ratio> list = ratios(report);
    if (!list.empty()) text.append("\n").append(ratio_table(list));
    const std::string notes = note_lines(report);
    if (!notes.empty()) text.append("\n").append(notes);
    return text;
}

}  // namespace pelage::bench
