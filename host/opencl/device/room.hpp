// Whether OpenCL drivers fit into this process, where its size is limited: one that is short of memory may wait for
// ever.
#pragma once

#include <string>

namespace pelage {

// In one sentence, with the numbers; empty: there is room, or no limit. To be asked before the first OpenCL call.
std::string why_no_room();

// From now on threads share one reserve of memory instead of having 64 MiB of the address space each.
void be_sparing();

}  // namespace pelage
