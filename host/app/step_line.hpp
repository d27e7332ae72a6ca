// How far a training has come: a line now and then, which on a terminal the next one replaces.
#pragma once

#include <chrono>
#include <cstdint>

namespace pelage::app {

class StepLine {
public:
    // The training's steps go from `first` + 1 to `last`.
    StepLine(bool quiet, std::uint64_t last, std::uint64_t first);
    ~StepLine() { clear(); }
    StepLine(const StepLine&) = delete;
    StepLine& operator=(const StepLine&) = delete;

    void show(std::uint64_t step, double loss);  // NaN: no step had one yet
    void clear();

private:
    using Clock = std::chrono::steady_clock;

    bool quiet_, terminal_, drawn_ = false;
    std::uint64_t last_, first_;
    Clock::time_point start_ = Clock::now(), shown_ = start_;
};

}  // namespace pelage::app
