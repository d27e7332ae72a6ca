// See explain.hpp.
#include "opencl/lattice/explain.hpp"

#include "core/schedule.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <variant>

namespace pelage {

namespace {

constexpr std::size_t most_sentences = 32;

// "no rule", "the rule of line 7", "the rules of lines 7, 9".
std::string named(const Experiment& experiment, const std::vector<bool>& active) {
    std::vector<std::size_t> lines;
    for (std::size_t i = 0; i < active.size(); ++i) {
        if (active[i]) lines.push_back(experiment.rules[i].line);
    }
    if (lines.empty()) return "no rule";
    return fmt::format("the rule{} of line{} {}", lines.size() == 1 ? "" : "s", lines.size() == 1 ? "" : "s",
                       fmt::join(lines, ", "));
}

std::string sentence(const Experiment& experiment, const LatticePlan& plan, Precision precision,
                     const std::vector<bool>& active, std::uint64_t iteration) {
    const std::string reason = why_not_streamed(plan, emit_rules(experiment, active, precision).use);
    return fmt::format("from iteration {}, {}: {}", iteration, named(experiment, active),
                       reason.empty() ? "fused; streamed once threads' caches do not hold the lattice"
                                      : "fused, steps shared among threads; not streamed: " + reason);
}

}  // namespace

std::string why_not_streamed(const LatticePlan& plan, const RuleUse& use) {
    if (use.random) return "random draws, not memory, set its pace";
    if (!use.polarizes.empty()) return "polarities that follow gradients, not memory, set its pace";
    if (std::find(plan.rates.begin(), plan.rates.end(), RateKind::per_cell) != plan.rates.end()) {
        return "diffusion rates that differ between cells, not memory, set its pace";
    }
    return "";
}

std::vector<std::string> explain_lattice(const Experiment& experiment, const Snapshot& initial, Precision precision) {
    if (std::holds_alternative<FreeCells>(space_of(experiment))) return {};
    const LatticePlan plan = lattice_plan(experiment, initial);
    std::vector<std::string> sentences;
    std::set<std::vector<bool>> known;
    const std::uint64_t last = experiment.last_iteration();
    for (std::uint64_t iteration = 0; iteration < last; iteration = next_change(experiment, iteration)) {
        std::vector<bool> active = active_rules(experiment, iteration);
        for (std::size_t i = 0; i < active.size(); ++i) {
            if (std::holds_alternative<Expand>(experiment.rules[i].action)) active[i] = false;
        }
        if (!known.insert(active).second) continue;
        if (sentences.size() == most_sentences) {
            sentences.push_back("and so on, with further sets of rules");
            break;
        }
        sentences.push_back(sentence(experiment, plan, precision, active, iteration));
    }
    return sentences;
}

}  // namespace pelage
