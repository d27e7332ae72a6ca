// Lints of the course of a run: snapshots, phases, settings given twice, and the time step.
#include "core/stability.hpp"
#include "language/lints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <variant>

namespace pelage::language {

namespace {

constexpr std::array<std::string_view, 8> single_settings{"stop at",        "define time_step",      "define domain",
                                                          "define stencil", "define division_limit", "texture size",
                                                          "zoom level",     "colormap select"};

void check_snap_at(const Sheet& sheet, Cursor words, Reporter& report) {
    while (!words.done() && words.peek().text != "then") {
        const Token& token = words.peek();
        const std::uint64_t at = words.integer("the snapshot", 0, largest_iteration);
        if (at <= sheet.last) continue;
        report(words.place(token), fmt::format("the snapshot at {} never comes: the run ends at {}", at, sheet.last));
    }
}

void check_snap_from(const Sheet& sheet, Cursor words, Reporter& report) {
    const Place place = words.place(words.peek());
    const std::uint64_t first = words.integer("the first", 0, largest_iteration);
    words.expect("repeat");
    const std::uint64_t count = words.integer("the number", 1, forever);
    words.expect("step");
    const std::uint64_t step = words.integer("the step", 1, largest_iteration);
    const std::uint64_t taken = first > sheet.last ? 0 : std::min(count, (sheet.last - first) / step + 1);
    if (taken == count) return;
    report(place, fmt::format("{} of the {} snapshots never come: the run ends at {}, the last one would be at {}",
                              count - taken, count, sheet.last, first + (count - 1) * step));
}

// What each chemical's rate is at most when the run begins, and the line that gives it.
struct Rate {
    double most = 0.0;
    std::size_t line = 0;
};

std::vector<Rate> initial_rates(const Sheet& sheet) {
    std::vector<Rate> used(sheet.experiment.chemicals.size());  // by the next `create`
    std::vector<Rate> rates = used;
    const auto most = [](const Spread& spread) { return spread.value + spread.deviation; };
    for (std::size_t i = 0; i < sheet.experiment.prepattern.size(); ++i) {
        const Statement& statement = sheet.experiment.prepattern[i];
        const std::size_t line = sheet.outline.prepattern[i];
        const auto raise = [&](std::size_t chemical, const Rate& rate) {
            if (rate.most > rates[chemical].most) rates[chemical] = rate;
        };
        if (const auto* use = std::get_if<UseChemical>(&statement)) {
            if (use->diff) used[use->chemical] = {most(*use->diff), line};
        } else if (const auto* set = std::get_if<SetCells>(&statement)) {
            const auto* rate = std::get_if<SetRate>(&set->what);
            if (rate != nullptr) raise(rate->chemical, {most(rate->value), line});
        } else if (!std::holds_alternative<UsePolarity>(statement) && !std::holds_alternative<UseSeed>(statement)) {
            for (std::size_t chemical = 0; chemical < used.size(); ++chemical) raise(chemical, used[chemical]);
        }
    }
    return rates;
}

// The statement of the phase that changes the chemical's rate, or that sets its time step, or begins it.
std::size_t line_of_cause(const Sheet& sheet, const Instability& found, const Rate& initial) {
    std::size_t phase = 0;  // as the outline counts them: 0 before the first
    for (std::size_t i = 0; i < sheet.outline.phases.size(); ++i) {
        const Phase& one = sheet.experiment.phases[i];
        if (phase == 0 && one.name == found.phase && one.time_step == found.time_step) phase = i + 1;
    }
    std::size_t line = initial.line;
    for (const Outline::Statement& statement : sheet.outline.statements) {
        if (statement.phase == 0 || statement.phase > phase) continue;
        if (statement.what == "define time_step" && statement.phase == phase) return statement.line;
        Cursor words = sheet.read(statement.line);
        words.next();
        words.next();
        if (statement.what == "use chemical" && words.peek().text == found.chemical) line = statement.line;
    }
    return line;
}

}  // namespace

void find_late_snapshots(const Sheet& sheet, Reporter& report) {
    for (const Outline::Statement& statement : sheet.outline.statements) {
        if (statement.what != "snap at" && statement.what != "snap from") continue;
        Cursor words = sheet.read(statement.line);
        words.next();
        words.next();
        if (statement.what == "snap at")
            check_snap_at(sheet, words, report);
        else
            check_snap_from(sheet, words, report);
    }
}

void find_idle_phases(const Sheet& sheet, Reporter& report) {
    for (std::size_t i = 0; i < sheet.outline.phases.size(); ++i) {
        const Phase& phase = sheet.experiment.phases[i];
        if (phase.begin < sheet.last) continue;
        report(sheet.place(sheet.outline.phases[i]),
               fmt::format("phase '{}' never begins: it would at {}, and the run ends at {}", phase.name, phase.begin,
                           sheet.last));
    }
}

void find_repeated_settings(const Sheet& sheet, Reporter& report) {
    std::map<std::pair<std::string_view, std::size_t>, std::size_t> latest;  // line of a setting in its phase
    for (const Outline::Statement& statement : sheet.outline.statements) {
        if (std::ranges::find(single_settings, statement.what) == single_settings.end()) continue;
        if (std::ranges::find(sheet.experiment.stencils, statement.line, &NamedStencil::line) !=
            sheet.experiment.stencils.end())
            continue;
        const bool phased = statement.what == "define time_step";
        const auto [before, fresh] = latest.try_emplace({statement.what, phased ? statement.phase : 0}, statement.line);
        if (fresh) continue;
        report(sheet.place(statement.line),
               fmt::format("'{}' stands in line {} already; this line replaces it", statement.what, before->second));
        before->second = statement.line;
    }
}

void find_backward_networks(const Sheet& sheet, Reporter& report) {
    for (const Rule& rule : sheet.experiment.rules) {
        const auto* neural = std::get_if<Neural>(&rule.action);
        if (neural == nullptr || neural->rate.quantity != Quantity::number || neural->rate.value >= 0.0) continue;
        report(sheet.place(rule.line, "rate"),
               fmt::format("the rate {} of a network is below 0: its reaction runs backwards, away from what it has "
                           "learned",
                           neural->rate.value));
    }
}

void find_unstable_steps(const Sheet& sheet, Reporter& report) {
    const std::vector<Rate> rates = initial_rates(sheet);
    Snapshot initial;  // one cell with the largest rates
    for (const Rate& rate : rates) initial.diff.push_back({rate.most});
    const std::optional<Instability> found = find_instability(sheet.experiment, initial);
    if (!found) return;
    const bool by_network = found->network > found->rate && found->line != 0;
    const std::size_t line =
        by_network ? found->line : line_of_cause(sheet, *found, rates[sheet.experiment.chemical(found->chemical)]);
    const std::string where = found->phase.empty() ? "" : fmt::format(" in phase '{}'", found->phase);
    report(sheet.place(line, by_network ? "diffusion" : "diff"),
           fmt::format("chemical '{}' diffuses unstably{}: with {} the time step may be {:.6g} at most, it "
                       "is {}; `run` asks for --force",
                       found->chemical, where, found->rates(), found->largest_time_step, found->time_step));
}

}  // namespace pelage::language
