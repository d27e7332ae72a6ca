// Which rules act when: lets a backend run many iterations with one and the same set of rules.
#pragma once

#include "core/experiment.hpp"

#include <cstdint>
#include <vector>

namespace pelage {

// Rules that are events (core/events.hpp) are never among them.
std::vector<bool> active_rules(const Experiment&, std::uint64_t iteration);

// The first iteration after `iteration` at which another set of rules is active; forever when there is none.
std::uint64_t next_change(const Experiment&, std::uint64_t iteration);

// The first iteration >= `iteration` at which the rule is active; forever when there is none.
std::uint64_t next_active(const Rule&, std::uint64_t iteration);

}  // namespace pelage
