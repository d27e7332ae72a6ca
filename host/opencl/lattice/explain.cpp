// See explain.hpp.
#include "opencl/lattice/explain.hpp"

#include "core/allowance.hpp"
#include "core/lattice.hpp"
#include "core/schedule.hpp"
#include "opencl/lattice/choice.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

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

}  // namespace

DeviceInfo usual_processor() {
    DeviceInfo device;
    device.type = "cpu";
    device.processors = usable_processors();
    device.compute_units = static_cast<std::uint32_t>(device.processors);
    device.local_memory = 1 << 20;
    device.max_work_group = 4096;
    device.vector_width_float = 16;
    device.vector_width_double = 8;
    return device;
}

std::vector<std::string> explain_lattice(const Experiment& experiment, const Snapshot& initial, Precision precision,
                                         const DeviceInfo& device) {
    if (std::holds_alternative<FreeCells>(space_of(experiment))) return {};
    const LatticePlan plan = lattice_plan(experiment, initial);
    const std::vector<bool> every(experiment.rules.size(), true);
    const double bytes = bytes_a_cell(experiment, plan, emit_rules(experiment, every, precision).use, precision);
    OpenclOptions options;
    options.precision = precision;
    std::vector<std::string> sentences;
    std::set<std::vector<bool>> known;
    const std::uint64_t last = experiment.last_iteration();
    for (std::uint64_t iteration = 0; iteration < last; iteration = next_change(experiment, iteration)) {
        const std::vector<bool> active = active_rules(experiment, iteration);
        if (!known.insert(active).second) continue;
        if (sentences.size() == most_sentences) {
            sentences.push_back("and so on, with further sets of rules");
            break;
        }
        const Work work = foreseen_work(experiment, active, iteration, static_cast<double>(initial.cells()), bytes);
        const RuleNeeds needs = rule_needs(experiment, plan, emit_rules(experiment, active, precision).use);
        sentences.push_back(fmt::format("from iteration {}, {}: {}", iteration, named(experiment, active),
                                        choose(device, needs, work, options).text()));
    }
    return sentences;
}

}  // namespace pelage
