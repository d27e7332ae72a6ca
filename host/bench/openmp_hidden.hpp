// A network and its diffusion in the C++ baseline, for 16 cells side by side: vectors of AVX-512 by hand where the
// processor has them.
#pragma once

#include <cstddef>

namespace pelage::bench {

inline constexpr std::size_t network_lanes = 16;

struct NetworkTable {
    std::size_t chemicals = 0;       // at most 64
    std::size_t hidden = 0;          // a multiple of 8
    const float* weights = nullptr;  // as network_table() orders them
};

// f[16 * chemical + lane] = (act(x W0 + b0) W1) of x[chemical][lane], with the reference's bits.
void ask_network(const NetworkTable&, const float* const* x, float* f);

// One chemical of these cells: the own row and those below and above, read from element -1 to 16. With w = 2/3 for
// those beside and 1/6 for those at corners, next = own + share * sum(w (theirs - own)) + dt * flow, by fma from the
// lower left on.
struct NetworkRows {
    const float *below = nullptr, *own = nullptr, *above = nullptr;
    float share = 0, dt = 0;
    const float* flow = nullptr;
    float* next = nullptr;
};

void add_flow(const NetworkRows&);

}  // namespace pelage::bench
