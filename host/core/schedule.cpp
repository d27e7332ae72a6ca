// See schedule.hpp.
#include "core/schedule.hpp"

#include "core/events.hpp"

#include <algorithm>

namespace pelage {

bool Rule::active(std::uint64_t iteration) const {
    if (iteration < from || iteration > until || iteration < origin) return false;
    const std::uint64_t since = iteration - origin;
    return since >= offset && (since - offset) % every == 0;
}

std::vector<bool> active_rules(const Experiment& experiment, std::uint64_t iteration) {
    std::vector<bool> active;
    active.reserve(experiment.rules.size());
    for (const Rule& rule : experiment.rules) active.push_back(!is_event(rule) && rule.active(iteration));
    return active;
}

std::uint64_t next_active(const Rule& rule, std::uint64_t iteration) {
    const std::uint64_t start = std::max({iteration, rule.from, rule.origin + rule.offset});
    const std::uint64_t late = (start - rule.origin - rule.offset) % rule.every;
    const std::uint64_t next = late == 0 ? start : start + (rule.every - late);
    return next <= rule.until ? next : forever;
}

std::uint64_t next_change(const Experiment& experiment, std::uint64_t iteration) {
    std::uint64_t change = forever;
    for (const Rule& rule : experiment.rules) {
        if (is_event(rule)) continue;
        std::uint64_t toggle = forever;
        if (!rule.active(iteration)) {
            toggle = next_active(rule, iteration);
        } else if (rule.every > 1) {
            toggle = iteration + 1;
        } else if (rule.until != forever) {
            toggle = rule.until + 1;
        }
        change = std::min(change, toggle);
    }
    return change;
}

}  // namespace pelage
