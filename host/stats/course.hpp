// What a pattern does in time: it stays, oscillates or moves.
#pragma once

#include "stats/grid.hpp"

#include <cstddef>
#include <string_view>
#include <vector>

namespace pelage::stats {

enum class Verdict { uniform, stationary, oscillating, moving, undecided, not_a_number, unstable };
// The last three are not for Course to find: too few states, NaNs, and a time step known not to hold.
std::string_view name_of(Verdict);

// Is shown the states of the last stretch of a run, all of one size, at equal intervals.
class Course {
public:
    void show(const Grid&);

    std::size_t states() const { return states_; }
    // Of at least two states. The variance over space and time is that of the mean picture and that around it in time:
    //   uniform      in no state do values differ by more than a thousandth, nor do they change in time; or all that
    //                differs is less than a millionth of `scale`, the largest value that the run has seen
    //   stationary   less than a ten thousandth of the variance is in time
    //   moving       the mean picture has less than half of it: what moves washes out
    //   oscillating  all else; a field that is uniform at all times and changes oscillates
    Verdict verdict(double scale = 0.0) const;

private:
    std::vector<double> sum_, squares_;
    double largest_ = 0.0;       // of all values, in size
    double largest_span_ = 0.0;  // highest less lowest within one state
    std::size_t states_ = 0;
    int excess_ = 0;  // all values are kept times 2^-excess_, where no square is infinite

    void make_room(int excess);
};

// Mean distance of two states, as a share of the span of the second; 0 where both are equal.
double change(const Grid& before, const Grid& after);

}  // namespace pelage::stats
