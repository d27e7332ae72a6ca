// Mirror pairs of free cells: after each step both cells of a pair take the mean of concentrations and rates.
#pragma once

#include "opencl/cells/state.hpp"
#include "opencl/device/session.hpp"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace pelage {

class CellMirrors {
public:
    using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

    // `service`: the program of cells/mirror.cl.
    CellMirrors(const Session& session, const cl::Program& service)
        : session_(session), kernel_(service, "pelage_cells_mirror") {}

    void take(const Pairs&);
    const Pairs& pairs() const { return pairs_; }

    // Pairs starts[i] .. starts[i + 1] - 1 of the sorted ones share no cell.
    const cl::Buffer& sorted() const { return sorted_; }
    const cl::Buffer& starts() const { return starts_; }
    int rounds() const { return static_cast<int>(rounds_.size()) - 1; }

    // Averages what step `step` of a batch has written, unless it was skipped.
    void enqueue(const CellsState&, const cl::Buffer& progress, int step, bool in_spare);

private:
    const Session& session_;
    cl::Kernel kernel_;
    Pairs pairs_;
    cl::Buffer sorted_;           // by round
    cl::Buffer starts_;           // of the rounds
    std::vector<cl_int> rounds_;  // the same on the host
};

}  // namespace pelage
