// Mirror pairs of free cells: after each step both cells of a pair take the mean of concentrations and rates.
#pragma once

#include "opencl/cells_state.hpp"
#include "opencl/session.hpp"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace pelage {

class CellMirrors {
public:
    using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

    // `service`: the program of cells_mirror.cl.
    CellMirrors(const Session& session, const cl::Program& service)
        : session_(session), kernel_(service, "pelage_cells_mirror") {}

    void take(const Pairs&);
    const Pairs& pairs() const { return pairs_; }

    // Averages what step `step` of a batch has written, unless it was skipped.
    void enqueue(const CellsState&, const cl::Buffer& progress, int step, bool in_spare);

private:
    const Session& session_;
    cl::Kernel kernel_;
    Pairs pairs_;
    cl::Buffer sorted_;                // by round
    std::vector<std::size_t> rounds_;  // pairs rounds_[i] .. rounds_[i + 1] - 1 of the sorted ones share no cell
};

}  // namespace pelage
