// Seeds of random numbers that come from the clock.
#pragma once

#include "core/experiment.hpp"

#include <cstdint>

namespace pelage {

// Another one at every call, in any process: 1 .. 2^53 - 1, which every reader of JSON holds exactly.
std::int64_t seed_from_clock();

// Truth where the experiment leaves its seed to the clock: `use seed 0`, or an Experiment::seed of 0.
bool seeded_by_clock(const Experiment&);

// Puts one number in the clock's place everywhere, so that giving it again repeats the run.
void settle_seed(Experiment&, std::int64_t seed = seed_from_clock());

}  // namespace pelage
