// See events.hpp.
#include "core/events.hpp"

#include "core/schedule.hpp"
#include "core/visit.hpp"

#include <algorithm>

namespace pelage {

std::optional<Event> event_of(const Rule& rule, std::size_t place) {
    using Made = std::optional<Event>;
    return std::visit(Overloaded{
                          [&](const Expand& growth) -> Made {
                              return Expansion{&growth, place};
                          },
                          [](const React&) -> Made { return {}; },
                          [](const Formula&) -> Made { return {}; },
                          [](const Neural&) -> Made { return {}; },
                          [](const Change&) -> Made { return {}; },
                          [](const Set&) -> Made { return {}; },
                          [](const Map&) -> Made { return {}; },
                          [](const Polarize&) -> Made { return {}; },
                          [](const Divide&) -> Made { return {}; },
                          [](const Move&) -> Made { return {}; },
                          [](const And&) -> Made { return {}; },
                          [](const Aggregate&) -> Made { return {}; },
                      },
                      rule.action);
}

std::vector<Event> events_before(const Experiment& experiment, std::uint64_t iteration) {
    std::vector<Event> events;
    const Phase& phase = experiment.phase_at(iteration);
    if (phase.begin == iteration) events.push_back(NewPhase{&phase});
    for (std::size_t place = 0; place < experiment.rules.size(); ++place) {
        const std::optional<Event> event = event_of(experiment.rules[place], place);
        if (event && experiment.rules[place].active(iteration)) events.push_back(*event);
    }
    return events;
}

std::uint64_t next_event(const Experiment& experiment, std::uint64_t iteration) {
    std::uint64_t next = forever;
    for (const Phase& phase : experiment.phases) {
        if (phase.begin > iteration) next = std::min(next, phase.begin);
    }
    for (const Rule& rule : experiment.rules) {
        if (is_event(rule)) next = std::min(next, next_active(rule, iteration + 1));
    }
    return next;
}

}  // namespace pelage
