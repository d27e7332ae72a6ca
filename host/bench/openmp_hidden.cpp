// See openmp_hidden.hpp. A block of hidden values stays in registers while all chemicals are added to it.
#include "bench/openmp_hidden.hpp"

#include "core/neural.hpp"
#include "reference/functions/quick_sigmoid.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#if defined(__x86_64__) && defined(__GNUC__)
#define PELAGE_BY_HAND
#include <immintrin.h>
#endif

namespace pelage::bench {

namespace {

using Lanes = std::array<float, network_lanes>;

void ask_plainly(const NetworkTable& table, const float* const* x, float* f) {
    const float* w = table.weights;
    std::fill_n(f, table.chemicals * network_lanes, 0.0f);
    for (std::size_t h = 0; h < table.hidden; h += hidden_block) {
        std::array<Lanes, hidden_block> z;
        for (Lanes& one : z) one.fill(*w++);
        for (std::size_t i = 0; i < table.chemicals; ++i) {
            for (Lanes& one : z) {
                for (std::size_t lane = 0; lane < network_lanes; ++lane)
                    one[lane] = std::fma(x[i][lane], *w, one[lane]);
                ++w;
            }
        }
        for (Lanes& one : z) {
            for (float& value : one) value = value * reference::functions::quick_sigmoid(5.0f * value);
        }
        for (std::size_t i = 0; i < table.chemicals; ++i) {
            for (const Lanes& one : z) {
                float* const sums = f + i * network_lanes;
                for (std::size_t lane = 0; lane < network_lanes; ++lane)
                    sums[lane] = std::fma(one[lane], *w, sums[lane]);
                ++w;
            }
        }
    }
}

constexpr float edge_share = 4.0f / 6.0f, corner_share = 1.0f / 6.0f;  // of the nine-point stencil

void add_plainly(const NetworkRows& of) {
    Lanes sums{};
    for (const float* row : {of.below, of.own, of.above}) {
        for (std::ptrdiff_t side = -1; side <= 1; ++side) {
            if (row == of.own && side == 0) continue;
            const float weight = row == of.own || side == 0 ? edge_share : corner_share;
            for (std::size_t lane = 0; lane < network_lanes; ++lane)
                sums[lane] = std::fma(weight, row[static_cast<std::ptrdiff_t>(lane) + side] - of.own[lane], sums[lane]);
        }
    }
    for (std::size_t lane = 0; lane < network_lanes; ++lane)
        of.next[lane] = std::fma(of.dt, of.flow[lane], std::fma(of.share, sums[lane], of.own[lane]));
}

#ifdef PELAGE_BY_HAND

#define PELAGE_WIDE __attribute__((target("avx512f"), always_inline)) static inline

// quick_sigmoid(), operation by operation.
PELAGE_WIDE __m512 wide_sigmoid(__m512 x) {
    using namespace reference::functions;
    const __m512 one = _mm512_set1_ps(1.0f), shift = _mm512_set1_ps(whole_shift<float>);
    // Not max and min, nor a shift by a number: g++ 12 warns of its own header's.
    const __m512 most = _mm512_set1_ps(40.0f), least = _mm512_set1_ps(-40.0f);
    const __m512 raised = _mm512_mask_blend_ps(_mm512_cmp_ps_mask(x, least, _CMP_LT_OQ), x, least);
    const __m512 held = _mm512_mask_blend_ps(_mm512_cmp_ps_mask(raised, most, _CMP_GT_OQ), raised, most);
    const __m512 u = _mm512_sub_ps(_mm512_set1_ps(-0.0f), held);
    const __m512 shifted = _mm512_add_ps(_mm512_mul_ps(u, _mm512_set1_ps(0x1.715476p+0f)), shift);
    const __m512 k = _mm512_sub_ps(shifted, shift);
    const __m512 r =
        _mm512_fnmadd_ps(k, _mm512_set1_ps(ln2_low<float>), _mm512_fnmadd_ps(k, _mm512_set1_ps(ln2_high<float>), u));
    __m512 tail = _mm512_set1_ps(0x1.9a981p-13f);
    for (const float next : {0x1.6d5146p-10f, 0x1.1115b4p-7f, 0x1.5554e4p-5f, 0x1.555552p-3f, 0x1.0p-1f})
        tail = _mm512_fmadd_ps(tail, r, _mm512_set1_ps(next));
    const __m512i bits = _mm512_castps_si512(_mm512_add_ps(k, shift));
    const __m512i exponent = _mm512_mullo_epi32(bits, _mm512_set1_epi32(1 << 23));
    const __m512 power_of_two = _mm512_castsi512_ps(_mm512_add_epi32(exponent, _mm512_set1_epi32(0x3f800000)));
    const __m512 power = _mm512_mul_ps(_mm512_add_ps(one, _mm512_fmadd_ps(_mm512_mul_ps(r, r), tail, r)), power_of_two);
    const __m512 d = _mm512_add_ps(one, power);
    __m512 y = _mm512_castsi512_ps(_mm512_sub_epi32(_mm512_set1_epi32(0x7ef311c7), _mm512_castps_si512(d)));
    for (int step = 0; step < 2; ++step) {
        const __m512 e = _mm512_fnmadd_ps(d, y, one);
        y = _mm512_fmadd_ps(y, _mm512_fmadd_ps(e, e, e), y);
    }
    return y;
}

__attribute__((target("avx512f"))) void ask_by_hand(const NetworkTable& table, const float* const* x, float* f) {
    const float* w = table.weights;
    std::fill_n(f, table.chemicals * network_lanes, 0.0f);
    for (std::size_t h = 0; h < table.hidden; h += hidden_block) {
        __m512 z[hidden_block];
        for (std::size_t k = 0; k < hidden_block; ++k) z[k] = _mm512_set1_ps(*w++);
        for (std::size_t i = 0; i < table.chemicals; ++i, w += hidden_block) {
            const __m512 value = _mm512_loadu_ps(x[i]);
            for (std::size_t k = 0; k < hidden_block; ++k) z[k] = _mm512_fmadd_ps(value, _mm512_set1_ps(w[k]), z[k]);
        }
        for (std::size_t k = 0; k < hidden_block; ++k)
            z[k] = _mm512_mul_ps(z[k], wide_sigmoid(_mm512_mul_ps(_mm512_set1_ps(5.0f), z[k])));
        for (std::size_t i = 0; i < table.chemicals; ++i, w += hidden_block) {
            __m512 sum = _mm512_loadu_ps(f + i * network_lanes);
            for (std::size_t k = 0; k < hidden_block; ++k) sum = _mm512_fmadd_ps(z[k], _mm512_set1_ps(w[k]), sum);
            _mm512_storeu_ps(f + i * network_lanes, sum);
        }
    }
}

__attribute__((target("avx512f"))) void add_by_hand(const NetworkRows& of) {
    const __m512 own = _mm512_loadu_ps(of.own);
    const __m512 edge = _mm512_set1_ps(edge_share), corner = _mm512_set1_ps(corner_share);
    __m512 sum = _mm512_set1_ps(0.0f);
    for (const float* row : {of.below, of.own, of.above}) {
        const __m512 outer = row == of.own ? edge : corner;
        sum = _mm512_fmadd_ps(outer, _mm512_sub_ps(_mm512_loadu_ps(row - 1), own), sum);
        if (row != of.own) sum = _mm512_fmadd_ps(edge, _mm512_sub_ps(_mm512_loadu_ps(row), own), sum);
        sum = _mm512_fmadd_ps(outer, _mm512_sub_ps(_mm512_loadu_ps(row + 1), own), sum);
    }
    const __m512 spread = _mm512_fmadd_ps(_mm512_set1_ps(of.share), sum, own);
    _mm512_storeu_ps(of.next, _mm512_fmadd_ps(_mm512_set1_ps(of.dt), _mm512_loadu_ps(of.flow), spread));
}

#endif

#ifdef PELAGE_BY_HAND
bool has_wide_vectors() {
    static const bool has = __builtin_cpu_supports("avx512f");
    return has;
}
#endif

}  // namespace

void ask_network(const NetworkTable& table, const float* const* x, float* f) {
#ifdef PELAGE_BY_HAND
    if (has_wide_vectors()) return ask_by_hand(table, x, f);
#endif
    ask_plainly(table, x, f);
}

void add_flow(const NetworkRows& of) {
#ifdef PELAGE_BY_HAND
    if (has_wide_vectors()) return add_by_hand(of);
#endif
    add_plainly(of);
}

}  // namespace pelage::bench
