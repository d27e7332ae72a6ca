// See structure.hpp.
#include "opencl/lattice/structure.hpp"

#include "core/events.hpp"
#include "core/lattice.hpp"
#include "core/space.hpp"
#include "opencl/lattice/emit_lattice.hpp"
#include "opencl/lattice/planes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <variant>

namespace pelage {

namespace {

bool may_be_member(const Experiment& experiment) {
    const Space space = space_of(experiment);
    const auto* lattice = std::get_if<Lattice>(&space);
    return lattice != nullptr && !lattice->charges && std::ranges::none_of(experiment.rules, is_event);
}

// When what acts.
std::string times_of(const Experiment& experiment) {
    std::string text;
    for (const Rule& rule : experiment.rules)
        text += fmt::format("{} {} {} {} {}\n", rule.from, rule.until, rule.every, rule.offset, rule.origin);
    for (const Phase& phase : experiment.phases) {
        text += fmt::format("phase {}", phase.begin);
        for (const auto& rate : phase.rates) text += rate ? " rate" : " -";
        text += "\n";
    }
    return text;
}

}  // namespace

std::string structure_of(const Experiment& experiment, const Snapshot& initial, Precision precision) {
    if (!may_be_member(experiment)) return "";
    const LatticePlan plan = lattice_plan(experiment, initial);
    const std::vector<bool> every(experiment.rules.size(), true);
    const RuleText rules = emit_rules(experiment, every, precision, true);
    std::string text = fmt::format("{} x {} at {} {}, iteration {}\n", initial.columns, initial.rows, initial.origin_x,
                                   initial.origin_y, initial.iteration);
    text += times_of(experiment);
    return text +
           lattice_source(experiment, plan, rules, bounded_chemicals(experiment), precision, 1, false, false, true);
}

std::size_t batch_room(const DeviceInfo& device, const Experiment& experiment, const Snapshot& initial,
                       Precision precision) {
    const LatticePlan plan = lattice_plan(experiment, initial);
    const std::size_t scalar = precision == Precision::double_ ? 8 : 4;
    const std::size_t plane = Grid{initial.columns, initial.rows}.plane() * scalar;
    const std::size_t conc = experiment.chemicals.size(), own = own_rates(plan), mappings = experiment.mappings.size(),
                      fields = experiment.fields.size(), polarity = plan.polarity ? 2 : 0;
    const std::size_t largest = std::max({conc, own, mappings, fields, polarity, std::size_t{1}}) * plane;
    const std::size_t all = (2 * (conc + own + mappings + polarity) + fields + 2) * plane;
    constexpr std::uint64_t part = 2;  // of the memory, beside what others have of it
    return static_cast<std::size_t>(std::min(device.max_allocation / (largest + 1), device.memory / part / all));
}

}  // namespace pelage
