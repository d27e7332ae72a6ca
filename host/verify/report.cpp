// See report.hpp.
#include "verify/report.hpp"

#include "core/counted.hpp"
#include "verify/evidence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <map>
#include <set>

namespace pelage::verify {

void Summary::add(const Result& result) {
    ++cases;
    switch (result.verdict) {
        case Verdict::passed:
            ++passed;
            break;
        case Verdict::failed:
            ++failed;
            break;
        case Verdict::mistrusted:
            ++mistrusted;
            break;
        case Verdict::skipped:
            ++skipped;
            break;
    }
    cells_compared += result.cells_compared;
    cells_differing += result.cells_differing;
    max_ulp = std::max(max_ulp, result.max_ulp);
    max_absolute = std::max(max_absolute, result.max_absolute);
    max_relative = std::max(max_relative, result.max_relative);
}

Verdict Summary::verdict() const {
    if (failed > 0) return Verdict::failed;
    if (mistrusted > 0) return Verdict::mistrusted;
    return passed > 0 ? Verdict::passed : Verdict::skipped;
}

std::vector<Summary> by_kernel(const std::vector<Result>& results) {
    std::vector<Summary> summaries;
    for (const Result& result : results) {
        auto at = std::ranges::find(summaries, result.kernel, &Summary::kernel);
        if (at == summaries.end()) {
            summaries.emplace_back().kernel = result.kernel;
            at = summaries.end() - 1;
        }
        at->add(result);
    }
    return summaries;
}

Summary total(const std::vector<Result>& results) {
    Summary sum;
    sum.kernel = "all";
    for (const Result& result : results) sum.add(result);
    return sum;
}

Summary total(const Report& report) {
    Summary sum;
    sum.kernel = "all";
    for (const DeviceReport& device : report.devices) {
        for (const Result& result : device.results) sum.add(result);
    }
    return sum;
}

const char* verdict_word(const Report& report) {
    return report.left_out > 0 ? "stopped" : word(total(report).verdict());
}

std::vector<std::string> conditions(const Report& report) {
    std::vector<std::string> found;
    if (!report.kernels.empty())
        found.push_back(fmt::format("Kernels came from PELAGE_KERNELS, '{}', not from this program", report.kernels));
    if (!report.schedule.empty())
        found.push_back(fmt::format("Work was done in the order of PELAGE_SCHEDULE, '{}'", report.schedule));
    if (report.left_out > 0)
        found.push_back(
            fmt::format("A signal stopped it: {} left out", counted(report.left_out, "check was", "checks were")));
    return found;
}

std::vector<std::string> unlike(const Report& report) {
    std::map<std::string, std::map<std::string, std::vector<std::size_t>>> groups;  // check, fingerprint, devices
    for (const DeviceReport& device : report.devices) {
        for (const Result& result : device.results) {
            if (result.verdict == Verdict::skipped) continue;
            groups[result.name][result.fingerprint].push_back(device.device.index);
        }
    }
    std::vector<std::string> lines;
    for (const auto& [name, prints] : groups) {
        if (prints.size() < 2) continue;
        std::string line = name + ":";
        for (const auto& [fingerprint, devices] : prints) {
            line += fmt::format(" {} on", fingerprint);
            for (const std::size_t device : devices) line += fmt::format(" {}", device);
        }
        lines.push_back(line);
    }
    return lines;
}

Result judge(const Check& check, Place& place, const std::filesystem::path& evidence) {
    const auto start = std::chrono::steady_clock::now();
    const Outcome outcome = carry_out(check, place);
    Result result;
    result.name = check.name;
    result.kernel = check.kernel;
    result.verdict = outcome.verdict;
    result.message = outcome.message;
    result.broken_off = outcome.broken_off;
    result.first = outcome.tally.first;
    result.cells_compared = outcome.tally.cells_compared;
    result.cells_differing = outcome.tally.cells_differing;
    result.max_ulp = outcome.tally.max_ulp;
    result.max_absolute = outcome.tally.max_absolute;
    result.max_relative = outcome.tally.max_relative;
    result.fingerprint = fmt::format("{:016x}", outcome.tally.found.value());
    if (outcome.evidence && result.verdict == Verdict::failed && !evidence.empty()) {
        try {
            result.files = keep_evidence(*outcome.evidence, check.name, evidence);
        } catch (const std::exception& failure) {  // what was found is worth more than its pictures
            result.message += fmt::format("{}no pictures: {}", result.message.empty() ? "" : "; ", failure.what());
        }
    }
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
}

std::string ulp_text(std::uint64_t ulps) {
    if (ulps == std::numeric_limits<std::uint64_t>::max()) return "no number";
    constexpr std::uint64_t fits_the_table = 100'000'000;
    return ulps < fits_the_table ? grouped(ulps) : fmt::format("{:.1e}", static_cast<double>(ulps));
}

std::string table(const std::vector<Result>& results) {
    std::string text = fmt::format("{:<20} {:>5} {:>12} {:>10} {:>10} {:>10} {:>10}  {}\n", "KERNEL", "CASES", "CELLS",
                                   "DIFFERING", "MAX ULP", "MAX ABS", "MAX REL", "VERDICT");
    std::vector<Summary> rows = by_kernel(results);
    for (const Summary& row : rows) {
        text += fmt::format("{:<20} {:>5} {:>12} {:>10} {:>10} {:>10.3g} {:>10.3g}  {}\n", row.kernel, row.cases,
                            grouped(row.cells_compared), grouped(row.cells_differing), ulp_text(row.max_ulp),
                            row.max_absolute, row.max_relative, word(row.verdict()));
    }
    return text;
}

}  // namespace pelage::verify
