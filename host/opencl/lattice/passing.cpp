// See passing.hpp.
#include "opencl/lattice/passing.hpp"

#include "opencl/lattice/emit_lattice.hpp"
#include "opencl/lattice/traits.hpp"

#include <fmt/format.h>

namespace pelage {

std::vector<Passing> passing_fields(const Experiment& experiment, const LatticePlan& plan, const RuleUse& use) {
    const LatticeTraits traits(experiment, plan, use);
    const std::vector<std::size_t> planes = rate_planes(plan);
    std::vector<Passing> seen, others;
    for (std::size_t i = 0; i < plan.rates.size(); ++i) {
        const bool watched = traits.watched(i);
        Passing field{"conc", i, watched ? fmt::format("a{}", i) : "", fmt::format("n{}", i), true};
        if (!traits.idle(i)) (watched ? seen : others).push_back(field);
        if (!traits.per_cell(i)) continue;
        const bool writes = traits.writes_rates();
        seen.push_back({"rate", planes[i], fmt::format("d{}", i), fmt::format("{}{}", writes ? 'q' : 'r', i), writes});
    }
    if (traits.polarity()) {
        seen.push_back({"polarity", 0, "old_px", traits.turns() ? "turned_x" : "px", traits.turns()});
        seen.push_back({"polarity", 1, "old_py", traits.turns() ? "turned_y" : "py", traits.turns()});
    }
    const bool maps = !use.mappings_written.empty();  // planes swap together: what is not written would be lost
    for (std::size_t i = 0; i < experiment.mappings.size(); ++i) {
        if (maps || traits.maps(i)) others.push_back({"mapping", i, "", fmt::format("m{}", i), maps});
    }
    seen.insert(seen.end(), others.begin(), others.end());
    return seen;
}

std::size_t count_seen(const std::vector<Passing>& fields) {
    std::size_t count = 0;
    for (const Passing& field : fields) count += field.middle.empty() ? 0 : 1;
    return count;
}

FusedFields fused_fields(const Experiment& experiment, const LatticePlan& plan, const RuleUse& use) {
    const std::vector<Passing> fields = passing_fields(experiment, plan, use);
    return {fields.size(), count_seen(fields)};
}

}  // namespace pelage
