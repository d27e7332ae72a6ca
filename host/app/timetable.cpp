// See timetable.hpp.
#include "app/timetable.hpp"

namespace pelage::app {

namespace {

bool falls_on(std::uint64_t iteration, std::uint64_t period) { return period != 0 && iteration % period == 0; }

std::uint64_t following(std::uint64_t iteration, std::uint64_t period) { return (iteration / period + 1) * period; }

}  // namespace

bool Timetable::snapshot_at(std::uint64_t iteration) const {
    return falls_on(iteration, snap_every) || std::binary_search(snap_at.begin(), snap_at.end(), iteration);
}

bool Timetable::checkpoint_at(std::uint64_t iteration) const {
    return iteration != 0 && falls_on(iteration, checkpoint_every);
}

std::uint64_t Timetable::next_stop(std::uint64_t iteration) const {
    std::uint64_t next = last;
    const auto snap = std::upper_bound(snap_at.begin(), snap_at.end(), iteration);
    if (snap != snap_at.end()) next = std::min(next, *snap);
    for (const std::uint64_t period : {snap_every, checkpoint_every}) {
        if (period != 0) next = std::min(next, following(iteration, period));
    }
    return next;
}

}  // namespace pelage::app
