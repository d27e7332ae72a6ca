// Programs whose work-groups and work-items come in another order than usual, and are late: for a developer who looks
// for races. The results must be the same bits. What the environment has in PELAGE_SCHEDULE says how:
//   reverse        the last work-group, and in it the last work-item, does the work of the first
//   random:NUMBER  they do each other's work in an order that is drawn from this seed, up to 2^32 - 1
// In both, whoever changes what others look at (claims, publications, counters) lingers before and after. Work is cut
// for all of the device's threads, though this process may have fewer processors. See kernels/common/schedule.cl.
#pragma once

#include <string>

namespace pelage {

std::string schedule();  // PELAGE_SCHEDULE; empty: not set

// The program's source as it must be for that. Throws Error where the schedule is none of those above.
std::string scheduled(const std::string& source);

}  // namespace pelage
