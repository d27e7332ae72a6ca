// Which of several cuts of a volume a processor carries out fastest, found while it works: none of them changes a bit.
// How many iterations and rows go through the caches together depends on their sizes and speeds, which OpenCL does not
// tell.
#pragma once

#include "core/space.hpp"
#include "opencl/lattice/choice.hpp"

#include <cstddef>
#include <limits>
#include <vector>

namespace pelage {

class VolumeCuts {
public:
    // Several where the choice is `streamed` and leaves the number of rows open (0), else that of the choice alone.
    VolumeCuts(const DeviceInfo&, const Choice&, const Volume&);

    const Choice& now() const;  // of the next launch
    bool searching() const { return timed_ < rounds * candidates_.size() && candidates_.size() > 1; }
    void took(double seconds_an_iteration);  // the launch of now(), while searching

private:
    struct Candidate {
        Choice choice;
        double seconds = std::numeric_limits<double>::infinity();  // an iteration, at best
    };

    static constexpr std::size_t rounds = 2;  // the first launch of all waits for the compiler

    std::vector<Candidate> candidates_;
    std::size_t timed_ = 0;
    std::size_t best_ = 0;
};

}  // namespace pelage
