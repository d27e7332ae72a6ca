// Independent pieces of work on several threads: files that are written at the same time.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace pelage {

// Carries out all of them, at most `threads` at a time, begun in their order. The first exception, in that order, is
// thrown again once all that have begun are done; those after it are not begun.
void run_together(const std::vector<std::function<void()>>& work, std::size_t threads);

}  // namespace pelage
