// The search: candidates one after another, within a budget, with nothing lost when it is interrupted.
#pragma once

#include "tune/record.hpp"

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace pelage::tune {

// Seconds, on the wall.
struct Budget {
    double whole = std::numeric_limits<double>::infinity();  // the search has ended by then
    double start = std::numeric_limits<double>::infinity();  // no new candidate is begun later
    double again = std::numeric_limits<double>::infinity();  // none is timed once more later
    double candidate = 20;                                   // may run so long; then it hangs
};

inline constexpr Budget quick_budget{5.0, 3.2, 4.2, 20.0};

struct Hands {
    // Tries a candidate, which may run for `running` seconds and have `whole` with its compilation; nothing: it had not
    // come to an end by then and was stopped.
    std::function<std::optional<Trial>(const Candidate&, double running, double whole)> try_out;
    std::function<void(const Record&)> keep;                                            // after every trial
    std::function<void(std::size_t done, std::size_t all, const Candidate&)> announce;  // before every trial
    std::function<double()> clock;                                                      // seconds since some moment
};

// Whether an exhaustive search under that budget would try candidates again that hung under a shorter limit.
bool has_more_patience(const Budget&, const Record&);

// Tries those that the record does not know, and has_more_patience() for. What hangs is remembered as such, what ran
// out of the whole budget is not. An exhaustive search forgets the times of an earlier quick one, never what that
// struck out. In the end those that would be chosen, and the defaults, are timed again in turn: other work on the
// machine slows now one and now another candidate, and the best of all its times counts for each. A search without time
// even for the defaults stays incomplete.
void search(Record&, const std::vector<Candidate>&, Effort, const Budget&, const Hands&);

}  // namespace pelage::tune
