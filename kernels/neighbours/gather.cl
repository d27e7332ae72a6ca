// What cells exchange with their neighbours in any space, neighbour after neighbour: compressed rows, as core/adjacency.hpp
// describes them. One value a cell in each array; a work-item takes one cell.

#define NOBODY 0xffffffffu  // beyond an absorbing edge: amounts of 0, at the cell's own rate

kernel void pelage_gather_neighbours(global const uint* offsets, global const uint* indices, global const scalar* weights,
                          global const scalar* rates, global const scalar* old, global scalar* next, const int cells,
                          const scalar dt) {
    const int cell = (int)get_global_id(0);
    if (cell >= cells) return;
    const scalar rate = rates[cell];
    const scalar own = old[cell];
    scalar n = next[cell];
    for (uint entry = offsets[cell]; entry < offsets[cell + 1]; ++entry) {
        const uint there = indices[entry];
        const scalar e = there == NOBODY ? rate : pelage_shared_rate(rate, rates[there]);
        const scalar difference = (there == NOBODY ? (scalar)0 : old[there]) - own;
        n = FLOW(n, e, weights[entry], difference);
    }
    next[cell] = n;
}
