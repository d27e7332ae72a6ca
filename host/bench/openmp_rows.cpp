// See openmp_rows.hpp. Compiled without errno of sqrt and without traps, which the loops need to become vectors;
// neither changes a value. Compiled once a level of x86-64, chosen when the program starts.
#include "bench/openmp_rows.hpp"

// ThreadSanitizer has not begun when the choice is made, and would break it.
#if defined(__x86_64__) && defined(__gnu_linux__) && !defined(__SANITIZE_THREAD__)
#define PELAGE_LEVELS __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define PELAGE_LEVELS
#endif

namespace pelage::bench {

namespace {

constexpr float range_square = 9;

}  // namespace

PELAGE_LEVELS
void sum_row(const float *__restrict row, float *__restrict sums, std::ptrdiff_t columns) {
#pragma omp simd
    for (std::ptrdiff_t i = 0; i < columns; ++i) sums[i] = __builtin_fmaf(4.0f, row[i], row[i - 1] + row[i + 1]);
}

// The reactions differ in the middle only; a template or a function would not be cloned by level with its caller.
#define PELAGE_ROW(NAME, FLOW_U, FLOW_V)                                                                               \
    PELAGE_LEVELS                                                                                                      \
    void NAME(const FieldRow &a, const FieldRow &b, const ReactionNumbers &numbers, std::ptrdiff_t columns) {          \
        const float *__restrict u_own = a.own, *__restrict u_above = a.above, *__restrict u_sums_below = a.sums_below, \
                                *__restrict u_sums_own = a.sums_own;                                                   \
        const float *__restrict v_own = b.own, *__restrict v_above = b.above, *__restrict v_sums_below = b.sums_below, \
                                *__restrict v_sums_own = b.sums_own;                                                   \
        float *__restrict u_sums_above = a.sums_above, *__restrict u_next = a.next;                                    \
        float *__restrict v_sums_above = b.sums_above, *__restrict v_next = b.next;                                    \
        const float u_share = a.share, u_floor = a.floor, u_limit = a.limit;                                           \
        const float v_share = b.share, v_floor = b.floor, v_limit = b.limit;                                           \
        const float sdt = numbers.sdt, p0 = numbers.p[0], p1 = numbers.p[1];                                           \
        _Pragma("omp simd") for (std::ptrdiff_t i = 0; i < columns; ++i) {                                             \
            const float u = u_own[i], v = v_own[i];                                                                    \
            const float su = __builtin_fmaf(4.0f, u_above[i], u_above[i - 1] + u_above[i + 1]);                        \
            const float sv = __builtin_fmaf(4.0f, v_above[i], v_above[i - 1] + v_above[i + 1]);                        \
            u_sums_above[i] = su;                                                                                      \
            v_sums_above[i] = sv;                                                                                      \
            const float lu = __builtin_fmaf(-36.0f, u, __builtin_fmaf(4.0f, u_sums_own[i], u_sums_below[i] + su));     \
            const float lv = __builtin_fmaf(-36.0f, v, __builtin_fmaf(4.0f, v_sums_own[i], v_sums_below[i] + sv));     \
            float nu = __builtin_fmaf(u_share, lu, __builtin_fmaf(sdt, FLOW_U, u));                                    \
            float nv = __builtin_fmaf(v_share, lv, __builtin_fmaf(sdt, FLOW_V, v));                                    \
            nu = nu < u_floor ? u_floor : nu;                                                                          \
            nu = nu > u_limit ? u_limit : nu;                                                                          \
            nv = nv < v_floor ? v_floor : nv;                                                                          \
            nv = nv > v_limit ? v_limit : nv;                                                                          \
            u_next[i] = nu;                                                                                            \
            v_next[i] = nv;                                                                                            \
        }                                                                                                              \
    }

PELAGE_ROW(turing_row, p0 - u * v, (u * v - v) - p1)
PELAGE_ROW(gray_scott_row, __builtin_fmaf(p0, 1.0f - u, -((u * v) * v)), __builtin_fmaf(-(p0 + p1), v, (u * v) * v))
#undef PELAGE_ROW

#define PELAGE_SEVEN(f)                                                                                     \
    (__builtin_fmaf(-4.0f, f##_own[i], (f##_below[i] + f##_above[i]) + (f##_own[i - 1] + f##_own[i + 1])) + \
     __builtin_fmaf(-2.0f, f##_own[i], f##_before[i] + f##_behind[i]))

PELAGE_LEVELS
void gray_scott_volume_row(const VolumeRow &a, const VolumeRow &b, const ReactionNumbers &numbers,
                           std::ptrdiff_t columns) {
    const float *__restrict u_own = a.own, *__restrict u_below = a.below, *__restrict u_above = a.above,
                            *__restrict u_before = a.before, *__restrict u_behind = a.behind;
    const float *__restrict v_own = b.own, *__restrict v_below = b.below, *__restrict v_above = b.above,
                            *__restrict v_before = b.before, *__restrict v_behind = b.behind;
    float *__restrict u_next = a.next, *__restrict v_next = b.next;
    const float u_share = a.share, u_floor = a.floor, u_limit = a.limit;
    const float v_share = b.share, v_floor = b.floor, v_limit = b.limit;
    const float sdt = numbers.sdt, f = numbers.p[0], loss = -(numbers.p[0] + numbers.p[1]);
#pragma omp simd
    for (std::ptrdiff_t i = 0; i < columns; ++i) {
        const float u = u_own[i], v = v_own[i], uvv = (u * v) * v;
        float nu = __builtin_fmaf(sdt, __builtin_fmaf(f, 1.0f - u, -uvv), u);
        float nv = __builtin_fmaf(sdt, __builtin_fmaf(loss, v, uvv), v);
        nu = __builtin_fmaf(u_share, PELAGE_SEVEN(u), nu);
        nv = __builtin_fmaf(v_share, PELAGE_SEVEN(v), nv);
        nu = nu < u_floor ? u_floor : nu;
        nu = nu > u_limit ? u_limit : nu;
        nv = nv < v_floor ? v_floor : nv;
        nv = nv > v_limit ? v_limit : nv;
        u_next[i] = nu;
        v_next[i] = nv;
    }
}
#undef PELAGE_SEVEN

PELAGE_LEVELS
void turing_mesh_block(const MeshBlock &block, const ReactionNumbers &numbers, std::size_t first) {
    const float *__restrict u = block.u, *__restrict v = block.v;
    const MeshBlock b = block;
    const float sdt = numbers.sdt, alpha = numbers.p[0], beta = numbers.p[1];
    alignas(64) float nu[16], nv[16];
#pragma omp simd
    for (std::size_t l = 0; l < 16; ++l) {
        const float mu = u[first + l], mv = v[first + l];
        nu[l] = __builtin_fmaf(sdt, alpha - mu * mv, mu);
        nv[l] = __builtin_fmaf(sdt, (mu * mv - mv) - beta, mv);
    }
    for (std::int32_t k = 0; k < b.length; ++k) {
        const std::int32_t *__restrict indices = b.indices + 16 * k;
        const float *__restrict share_u = b.weights_u + 16 * k, *__restrict share_v = b.weights_v + 16 * k;
#pragma omp simd
        for (std::size_t l = 0; l < 16; ++l) {
            nu[l] = __builtin_fmaf(share_u[l], u[indices[l]] - u[first + l], nu[l]);
            nv[l] = __builtin_fmaf(share_v[l], v[indices[l]] - v[first + l], nv[l]);
        }
    }
#pragma omp simd
    for (std::size_t l = 0; l < 16; ++l) {
        const float cu = nu[l] < b.floor_u ? b.floor_u : nu[l], cv = nv[l] < b.floor_v ? b.floor_v : nv[l];
        b.next_u[first + l] = cu > b.limit_u ? b.limit_u : cu;
        b.next_v[first + l] = cv > b.limit_v ? b.limit_v : cv;
    }
}

PELAGE_LEVELS
void cell_block(const CellArrays &arrays, const CellNumbers &numbers, std::size_t first) {
    const float *__restrict x = arrays.x, *__restrict y = arrays.y, *__restrict u = arrays.u, *__restrict v = arrays.v,
                            *__restrict du = arrays.du, *__restrict dv = arrays.dv;
    const CellNumbers n = numbers;
    alignas(64) float nx[16], ny[16], nu[16], nv[16];
    alignas(64) std::int32_t count[16];
#pragma omp simd
    for (std::size_t l = 0; l < 16; ++l) {
        const float mu = u[first + l], mv = v[first + l];
        nx[l] = x[first + l];
        ny[l] = y[first + l];
        nu[l] = mu + (n.scale * (n.alpha - mu * mv)) * n.dt;
        nv[l] = mv + (n.scale * ((mu * mv - mv) - n.beta)) * n.dt;
        count[l] = 0;
    }
    for (std::int32_t k = 0; k < arrays.length; ++k) {
        const std::int32_t *__restrict entries = arrays.entries + 16 * k;
#pragma omp simd
        for (std::size_t l = 0; l < 16; ++l) {
            const std::int32_t j = entries[l];
            const float dx = x[j] - x[first + l], dy = y[j] - y[first + l];
            const float d2 = dx * dx + dy * dy;
            const bool near = d2 < range_square;
            const float norm = __builtin_sqrtf(d2);
            const float au = du[first + l], bu = du[j], av = dv[first + l], bv = dv[j];
            const float eu = au == bu ? au : (2.0f * (au * bu)) / (au + bu);
            const float ev = av == bv ? av : (2.0f * (av * bv)) / (av + bv);
            const float wu = nu[l] + (eu * (u[j] - u[first + l])) * n.dt;
            const float wv = nv[l] + (ev * (v[j] - v[first + l])) * n.dt;
            nu[l] = near ? wu : nu[l];
            nv[l] = near ? wv : nv[l];
            const bool pushed = (norm > 0.0f) & (norm < 2.0f);
            const float weight = 0.25f - 0.5f / norm;
            const float px = nx[l] + weight * dx, py = ny[l] + weight * dy;
            nx[l] = pushed ? px : nx[l];
            ny[l] = pushed ? py : ny[l];
            count[l] += near ? 1 : 0;
        }
    }
#pragma omp simd
    for (std::size_t l = 0; l < 16; ++l) {
        const float cu = nu[l] < n.floor_u ? n.floor_u : nu[l], cv = nv[l] < n.floor_v ? n.floor_v : nv[l];
        const float cx = nx[l] < -n.half_width ? -n.half_width : nx[l];
        const float cy = ny[l] < -n.half_height ? -n.half_height : ny[l];
        arrays.next_u[first + l] = cu > n.limit_u ? n.limit_u : cu;
        arrays.next_v[first + l] = cv > n.limit_v ? n.limit_v : cv;
        arrays.next_x[first + l] = cx > n.half_width ? n.half_width : cx;
        arrays.next_y[first + l] = cy > n.half_height ? n.half_height : cy;
        arrays.neighbours[first + l] = count[l];
    }
}

PELAGE_LEVELS
float farthest(const float *__restrict x, const float *__restrict y, const float *__restrict from_x,
               const float *__restrict from_y, std::size_t begin, std::size_t end) {
    float most = 0;
#pragma omp simd reduction(max : most)
    for (std::size_t i = begin; i < end; ++i) {
        const float dx = x[i] - from_x[i], dy = y[i] - from_y[i];
        const float d2 = dx * dx + dy * dy;
        most = d2 > most ? d2 : most;
    }
    return most;
}

PELAGE_LEVELS
void copy_row(const float *__restrict from, float *__restrict to, std::size_t count) {
#pragma omp simd
    for (std::size_t i = 0; i < count; ++i) to[i] = from[i];
}

PELAGE_LEVELS
float fma_rounds(std::size_t rounds) {
    alignas(64) float sums[8][16];
    for (std::size_t chain = 0; chain < 8; ++chain) {
        for (std::size_t l = 0; l < 16; ++l) sums[chain][l] = static_cast<float>(16 * chain + l);
    }
    for (std::size_t round = 0; round < rounds; ++round) {
#pragma GCC unroll 8
        for (std::size_t chain = 0; chain < 8; ++chain) {
#pragma omp simd
            for (std::size_t l = 0; l < 16; ++l) sums[chain][l] = __builtin_fmaf(sums[chain][l], 0.999f, 0.25f);
        }
    }
    float total = 0;
    for (std::size_t i = 0; i < 128; ++i) total += sums[i / 16][i % 16];
    return total;
}

}  // namespace pelage::bench
