// What happens between two iterations, and in which order. Whoever asks what comes next, asks here.
#pragma once

#include "core/experiment.hpp"

#include <cstddef>
#include <cstdint>
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

// Whether a rule acts between iterations, as an event, and not within them.
bool is_event(const Rule&);

// Those that come before iteration `iteration` is carried out: the phase first, then rules in their order. They point
// into the experiment.
std::vector<Event> events_before(const Experiment&, std::uint64_t iteration);

// The first iteration after `iteration` that an event comes before; forever when there is none.
std::uint64_t next_event(const Experiment&, std::uint64_t iteration);

}  // namespace pelage
