// See tune_table.hpp.
#include "app/tune_table.hpp"

#include "app/progress.hpp"
#include "app/text_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace pelage::app {

namespace {

using tune::Candidate;
using tune::Trial;
using tune::Verdict;

std::string number_or_dash(std::size_t value) { return value == 0 ? "-" : std::to_string(value); }

std::string across(const tune::Candidate& candidate) {
    const LatticeCut& cut = candidate.cut;
    if (cut.columns == 0 && cut.rows == 0) return "-";
    return fmt::format("{} x {}", cut.columns, cut.rows);
}

TableLine line_of(const Trial& trial, std::size_t rank, double defaults) {
    const Candidate& candidate = trial.candidate;
    const bool good = trial.verdict == Verdict::good;
    return {good ? std::to_string(rank) : "-",
            candidate == Candidate{} ? "defaults" : word(candidate.path),
            number_or_dash(candidate.width),
            number_or_dash(candidate.cut.depth),
            across(candidate),
            number_or_dash(candidate.cut.group),
            good ? fmt::format("{} million", megas(trial.updates_per_second)) : "-",
            good && defaults > 0 ? fmt::format("{:.2f} x", trial.updates_per_second / defaults) : "-",
            word(trial.verdict)};
}

// Each once, with all that it befell.
std::string reasons(const std::vector<Trial>& trials) {
    std::vector<std::pair<std::string, std::vector<std::string>>> causes;
    for (const Trial& trial : trials) {
        if (trial.message.empty()) continue;
        const std::string cause = fmt::format("{}: {}", word(trial.verdict), trial.message);
        auto found = std::ranges::find(causes, cause, [](const auto& one) { return one.first; });
        if (found == causes.end()) found = causes.insert(causes.end(), {cause, {}});
        found->second.push_back(trial.candidate.text());
    }
    std::string text;
    for (const auto& [cause, names] : causes) {
        text += names.size() == 1
                    ? fmt::format("\n{}: {}\n", names.front(), cause)
                    : fmt::format("\n{} candidates {}\n  {}\n", names.size(), cause, fmt::join(names, "\n  "));
    }
    return text;
}

// What else wants the processors; empty: not known, or nothing to speak of.
std::string load() {
    double average = 0;
    if (getloadavg(&average, 1) != 1 || average < 0.5) return "";
    return fmt::format("{:.1f} processes want a processor at the moment; this machine has {}.\n", average,
                       std::max(1u, std::thread::hardware_concurrency()));
}

std::string no_time(const Tuning& tuning) {
    return fmt::format(
        "There was no time even for the defaults in {:.1f} s, so nothing is known and runs take these.\n{}"
        "Try again when the machine is less busy, or without --quick, which waits as long as it takes.\n",
        tuning.seconds, load());
}

std::string conclusion(const Tuning& tuning) {
    const tune::Record& record = tuning.record;
    const Candidate best = record.best();
    const std::string anew =
        tuning.not_kept.empty()
            ? ""
            : fmt::format("A later search begins anew, because nothing could be kept: {}.\n", tuning.not_kept);
    if (record.find({}) == nullptr) return no_time(tuning) + anew;
    const std::string memory = tuning.remembered ? "Remembered from an earlier search; --forget tries all anew. " : "";
    if (best == Candidate{}) {
        return fmt::format("{}Nothing is faster than the defaults by more than {:.0f} %: runs take these.\n{}", memory,
                           100 * tune::least_gain, anew);
    }
    const std::string gain =
        record.gain() > 0 ? fmt::format(", {:.0f} % faster than the defaults", 100 * record.gain()) : "";
    if (!anew.empty())
        return fmt::format("The fastest is: {}{}. Runs will not know of it.\n{}", best.text(), gain, anew);
    return fmt::format("{}Runs of this kind and size will take: {}{}.\n", memory, best.text(), gain);
}

}  // namespace

std::string tuning_table(const Tuning& tuning, const DeviceInfo& device) {
    const tune::Record& record = tuning.record;
    std::vector<Trial> trials = record.trials;
    std::ranges::stable_sort(trials, std::ranges::greater{}, &Trial::updates_per_second);
    const Trial* defaults = record.find({});
    const std::string head = fmt::format("{} ({}, driver {}), {} cells, {}\n", device.name, device.platform,
                                         device.driver, record.key.size, record.key.precision);
    if (trials.empty()) return head + conclusion(tuning);
    std::vector<TableLine> lines{{"RANK", "KERNEL", "WIDTH", "DEPTH", "COLUMNS x ROWS", "GROUP", "CELL-UPDATES/S",
                                  "AGAINST DEFAULTS", "VERDICT"}};
    for (std::size_t i = 0; i < trials.size(); ++i) {
        lines.push_back(line_of(trials[i], i + 1, defaults == nullptr ? 0 : defaults->updates_per_second));
    }
    return fmt::format("{}{}{}\n{}", head, aligned(lines), reasons(trials), conclusion(tuning));
}

}  // namespace pelage::app
