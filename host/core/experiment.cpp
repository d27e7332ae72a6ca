// See experiment.hpp: look-ups and names.
#include "core/experiment.hpp"

#include "core/error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace pelage {

std::size_t Experiment::chemical(const std::string& name) const {
    const auto found =
        std::find_if(chemicals.begin(), chemicals.end(), [&](const Chemical& c) { return c.name == name; });
    if (found != chemicals.end()) return static_cast<std::size_t>(found - chemicals.begin());
    std::vector<std::string> names;
    for (const Chemical& c : chemicals) names.push_back(c.name);
    throw Error(fmt::format("chemical '{}' is not defined; defined here: {}", name, fmt::join(names, ", ")));
}

namespace {

// The number, in its own file, of a line that no included file holds but the one that begins at `begin`.
std::size_t number_in_file(const std::vector<IncludedLines>& included, std::size_t begin, std::size_t line) {
    std::size_t number = line - begin + 1;
    std::size_t passed = 0;  // the last line of what was taken off
    for (const IncludedLines& one : included) {
        if (one.by < begin || one.by >= line || one.first <= passed) continue;
        number -= one.last + 2 - one.first;  // with the line that tells its end
        passed = one.last;
    }
    return number;
}

}  // namespace

std::string Experiment::where(std::size_t line) const {
    std::string place = source;
    std::size_t begin = 1;
    for (const IncludedLines& one : included) {
        if (line < one.first || (one.last != 0 && line > one.last)) continue;
        place += fmt::format(":{}: in {}", number_in_file(included, begin, one.by), one.file);
        begin = one.first;
    }
    return place + fmt::format(":{}", number_in_file(included, begin, line));
}

const Phase& Experiment::phase_at(std::uint64_t iteration) const {
    const Phase* current = &phases.front();
    for (const Phase& phase : phases) {
        if (phase.begin <= iteration) current = &phase;
    }
    return *current;
}

std::uint64_t Experiment::last_iteration() const {
    return exit_after_snaps && !snap_at.empty() ? std::min(stop_at, snap_at.back()) : stop_at;
}

double Experiment::time_at(std::uint64_t iteration) const {
    double time = 0.0;
    for (std::size_t i = 0; i < phases.size() && phases[i].begin < iteration; ++i) {
        const std::uint64_t end = i + 1 < phases.size() ? std::min(phases[i + 1].begin, iteration) : iteration;
        time += static_cast<double>(end - phases[i].begin) * phases[i].time_step;
    }
    return time;
}

std::string output_name(const Experiment& experiment, const Output& output) {
    if (!output.name.empty()) return output.name;
    if (output.expressions.empty()) return experiment.chemicals.at(output.chemical).name;
    return output.rgb() ? "rgb" : "formula";
}

std::int64_t Experiment::run_seed() const {
    if (seed) return *seed;
    std::int64_t last = 1;
    for (const Statement& statement : prepattern) {
        if (const auto* use = std::get_if<UseSeed>(&statement)) last = use->seed;
    }
    return last;
}

}  // namespace pelage
