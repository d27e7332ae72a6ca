// See mirror.hpp.
#include "opencl/cells/mirror.hpp"

#include <algorithm>
#include <map>

namespace pelage {

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
        rounds_.push_back(static_cast<cl_int>(sorted.size()));
        for (const auto& [a, b] : round) sorted.push_back({{static_cast<cl_int>(a), static_cast<cl_int>(b)}});
    }
    rounds_.push_back(static_cast<cl_int>(sorted.size()));
    starts_ = session_.buffer(rounds_.size() * sizeof(cl_int), "rounds of mirror pairs");
    session_.queue().enqueueWriteBuffer(starts_, CL_TRUE, 0, rounds_.size() * sizeof(cl_int), rounds_.data());
    sorted_ = session_.buffer(sorted.size() * sizeof(cl_int2), "mirror pairs");
    if (sorted.empty()) return;
    session_.queue().enqueueWriteBuffer(sorted_, CL_TRUE, 0, sorted.size() * sizeof(cl_int2), sorted.data());
}

void CellMirrors::enqueue(const CellsState& state, const cl::Buffer& progress, int step, bool in_spare) {
    for (std::size_t round = 0; round + 1 < rounds_.size(); ++round) {
        const cl_int count = rounds_[round + 1] - rounds_[round];
        Arguments(session_, kernel_)
            .add(sorted_, rounds_[round], count, state.pitch(), state.chemicals(), state.place_of(), progress, step,
                 in_spare ? state.spare(CellArray::conc) : state.now(CellArray::conc),
                 in_spare ? state.spare(CellArray::rate) : state.now(CellArray::rate));
        const auto items = static_cast<std::size_t>(count);
        launch(session_, kernel_, items, std::min<std::size_t>(items, 16));
    }
}

}  // namespace pelage
