// How far a run may advance at once: to the next snapshot or checkpoint, and never for long.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace pelage::app {

// Iterations at which a run stops between two batches to write something.
struct Timetable {
    std::uint64_t last = 0;              // where the run ends
    std::vector<std::uint64_t> snap_at;  // ascending
    std::uint64_t snap_every = 0;        // 0: never
    std::uint64_t checkpoint_every = 0;  // 0: never

    bool snapshot_at(std::uint64_t iteration) const;
    bool checkpoint_at(std::uint64_t iteration) const;
    std::uint64_t next_stop(std::uint64_t iteration) const;  // the first one after `iteration`
};

// Iterations a batch, so that one takes about `target` seconds whatever the tissue and the machine.
class BatchSize {
public:
    static constexpr double target = 0.15;

    std::uint64_t iterations() const { return size_; }

    // The last batch had `count` iterations. The first ones compile kernels: the size grows quickly, fourfold at most.
    // `growth`: how many times as many cells there were after it. Where they go on multiplying so, the next one does
    // not more than double them: what a batch takes can be foretold no further.
    void took(std::uint64_t count, double seconds, double growth) {
        double fitting = static_cast<double>(count) * target / std::max(seconds, 1e-9);
        if (growth > 1.0) fitting = std::min(fitting, static_cast<double>(count) * std::log(2.0) / std::log(growth));
        const auto largest = static_cast<double>(4 * std::max(size_, count));
        size_ = static_cast<std::uint64_t>(std::clamp(fitting, 1.0, std::min(largest, 1e9)));
    }

private:
    std::uint64_t size_ = 1;
};

}  // namespace pelage::app
