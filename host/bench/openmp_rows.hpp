// The inner loops of the C++ baseline: plain loops, vectorised by the compiler for the processor at hand.
// Formulas, association and fma are those of the reference, so that results are equal bit for bit.
#pragma once

#include <cstddef>
#include <cstdint>

namespace pelage::bench {

// One chemical's rows: `above` is read from element -1 to `columns`; the sums [1 4 1] of the rows below and of the own
// row are known, those of the row above are found and kept for the next row.
struct FieldRow {
    const float* own = nullptr;
    const float* above = nullptr;
    const float* sums_below = nullptr;
    const float* sums_own = nullptr;
    float* sums_above = nullptr;
    float* next = nullptr;
    float share = 0;  // rate * dt / 6
    float floor = 0;
    float limit = 0;
};

struct ReactionNumbers {
    float sdt = 0;     // scale * dt
    float p[2] = {0};  // the model's parameters
};

void sum_row(const float* row, float* sums, std::ptrdiff_t columns);
void turing_row(const FieldRow& u, const FieldRow& v, const ReactionNumbers&, std::ptrdiff_t columns);
void gray_scott_row(const FieldRow& u, const FieldRow& v, const ReactionNumbers&, std::ptrdiff_t columns);

// One chemical's rows in a volume: the own one, those below, above, before and behind it, read from element -1 to
// `columns` where sides are wanted.
struct VolumeRow {
    const float* own = nullptr;
    const float* below = nullptr;
    const float* above = nullptr;
    const float* before = nullptr;
    const float* behind = nullptr;
    float* next = nullptr;
    float share = 0;  // rate * dt
    float floor = 0;
    float limit = 0;
};

void gray_scott_volume_row(const VolumeRow& u, const VolumeRow& v, const ReactionNumbers&, std::ptrdiff_t columns);

// Cells of a mesh, 16 side by side: entry k of lane l at [16 * k + l]; short lists end in the cell itself with weight
// 0.
struct MeshBlock {
    const float *u = nullptr, *v = nullptr;  // of all cells
    const std::int32_t* indices = nullptr;
    const float *weights_u = nullptr, *weights_v = nullptr;  // (rate * dt) * share
    std::int32_t length = 0;
    float *next_u = nullptr, *next_v = nullptr;
    float floor_u = 0, limit_u = 0, floor_v = 0, limit_v = 0;
};

// One iteration of the 16 cells from place `first` on.
void turing_mesh_block(const MeshBlock&, const ReactionNumbers&, std::size_t first);

// Free cells, 16 side by side. All arrays are in places of bins; a place behind the last is infinitely far.
struct CellArrays {
    const float *x = nullptr, *y = nullptr, *u = nullptr, *v = nullptr, *du = nullptr, *dv = nullptr;
    const std::int32_t* entries = nullptr;  // of this block of 16: entry k of lane l at [16 * k + l]
    std::int32_t length = 0;                // of the block's longest list
    float *next_x = nullptr, *next_y = nullptr, *next_u = nullptr, *next_v = nullptr;
    std::int32_t* neighbours = nullptr;
};

struct CellNumbers {
    float dt = 0, scale = 0, alpha = 0, beta = 0;
    float half_width = 0, half_height = 0;
    float floor_u = 0, limit_u = 0, floor_v = 0, limit_v = 0;
};

// One iteration of the 16 cells from place `first` on.
void cell_block(const CellArrays&, const CellNumbers&, std::size_t first);

// The largest square of a displacement among places begin .. end - 1.
float farthest(const float* x, const float* y, const float* from_x, const float* from_y, std::size_t begin,
               std::size_t end);

// Yardsticks: to[i] = from[i]; and eight chains of 16 fma a round, whose sum must be used.
void copy_row(const float* from, float* to, std::size_t count);
float fma_rounds(std::size_t rounds);
inline constexpr double fma_flops_a_round = 2.0 * 8 * 16;

}  // namespace pelage::bench
