// What happens between two iterations, and in which order. Whoever asks what comes next, asks here.
#pragma once

#include "core/experiment.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

namespace pelage {

struct NewPhase {  // its rates become those of every cell
    const Phase* phase = nullptr;
};

struct Expansion {  // a lattice takes in columns and rows
    const Expand* growth = nullptr;
    std::size_t rule = 0;  // its place, which its draws depend on
};

using Event = std::variant<NewPhase, Expansion>;

// The event that the rule at this place is; empty for those that act within iterations.
std::optional<Event> event_of(const Rule&, std::size_t place);

inline bool is_event(const Rule& rule) { return event_of(rule, 0).has_value(); }

// Those that come before iteration `iteration` is carried out: the phase first, then rules in their order. They point
// into the experiment.
std::vector<Event> events_before(const Experiment&, std::uint64_t iteration);

// The first iteration after `iteration` that an event comes before; forever when there is none.
std::uint64_t next_event(const Experiment&, std::uint64_t iteration);

}  // namespace pelage
