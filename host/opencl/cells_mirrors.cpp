// See cells_mirrors.hpp.
#include "opencl/cells_mirrors.hpp"

#include <algorithm>
#include <map>

namespace pelage {

void CellMirrors::build(const cl::Program& program) { kernel_ = cl::Kernel(program, "pelage_cells_mirror"); }

// A pair goes into the round after the last one that touches either of its cells: the result is that of taking the
// pairs one after the other.
void CellMirrors::take(const Pairs& pairs) {
    pairs_ = pairs;
    rounds_.clear();
    std::map<std::uint32_t, std::size_t> rounds_of;  // how many rounds touch a cell so far
    std::vector<Pairs> rounds;
    for (const auto& [a, b] : pairs) {
        const std::size_t round = std::max(rounds_of[a], rounds_of[b]);
        if (round == rounds.size()) rounds.emplace_back();
        rounds[round].emplace_back(a, b);
        rounds_of[a] = rounds_of[b] = round + 1;
    }
    std::vector<cl_int2> sorted;
    for (const Pairs& round : rounds) {
        rounds_.push_back(sorted.size());
        for (const auto& [a, b] : round) sorted.push_back({{static_cast<cl_int>(a), static_cast<cl_int>(b)}});
    }
    if (sorted.empty()) return;
    rounds_.push_back(sorted.size());
    sorted_ = session_.buffer(sorted.size() * sizeof(cl_int2), "mirror pairs");
    session_.queue().enqueueWriteBuffer(sorted_, CL_TRUE, 0, sorted.size() * sizeof(cl_int2), sorted.data());
}

void CellMirrors::enqueue(const CellsState& state, const cl::Buffer& progress, int step, bool in_spare) {
    for (std::size_t round = 0; round + 1 < rounds_.size(); ++round) {
        const std::size_t count = rounds_[round + 1] - rounds_[round];
        Arguments(session_, kernel_)
            .add(sorted_, static_cast<cl_int>(rounds_[round]), static_cast<cl_int>(count), state.pitch(),
                 state.chemicals(), state.place_of(), progress, step,
                 in_spare ? state.spare(CellArray::conc) : state.now(CellArray::conc),
                 in_spare ? state.spare(CellArray::rate) : state.now(CellArray::rate));
        launch(session_, kernel_, count, std::min<std::size_t>(count, 16));
    }
}

}  // namespace pelage
