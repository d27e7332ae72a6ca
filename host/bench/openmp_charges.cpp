// See openmp_charges.hpp. Compiled as openmp_rows.cpp is.
#include "bench/openmp_charges.hpp"

// ThreadSanitizer has not begun when the choice is made, and would break it.
#if defined(__x86_64__) && defined(__gnu_linux__) && !defined(__SANITIZE_THREAD__)
#define PELAGE_LEVELS __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define PELAGE_LEVELS
#endif
#define PELAGE_WITHIN static inline __attribute__((always_inline))

namespace pelage::bench {

PELAGE_WITHIN std::int32_t bits_of(float x) { return __builtin_bit_cast(std::int32_t, x); }
PELAGE_WITHIN float of_bits(std::int32_t x) { return __builtin_bit_cast(float, x); }

PELAGE_WITHIN std::int32_t inverse_in_parts(std::int32_t dx, std::int32_t dy) {
    const float d = static_cast<float>(dx * dx + dy * dy);
    const float half = 0.5f * d;
    float y = of_bits(0x5f375a86 - (bits_of(d) >> 1));
    y = y * (1.5f - (half * y) * y);
    y = y * (1.5f - (half * y) * y);
    y = y * (1.5f - (half * y) * y);
    return static_cast<std::int32_t>(__builtin_rintf(y * 0x1p30f));
}

PELAGE_LEVELS
SumRange add_charge(const CandidateArrays &of, std::size_t begin, std::size_t end, std::int32_t x, std::int32_t y) {
    const std::int32_t *__restrict xs = of.x, *__restrict ys = of.y;
    std::int64_t *__restrict sums = of.sums;
    std::int64_t least = INT64_MAX, most = INT64_MIN;
#pragma omp simd reduction(min : least) reduction(max : most)
    for (std::size_t i = begin; i < end; ++i) {
        const std::int64_t sum = sums[i] + inverse_in_parts(xs[i] - x, ys[i] - y);
        sums[i] = sum;
        const std::int64_t low = xs[i] < 0 ? INT64_MAX : sum, high = xs[i] < 0 ? INT64_MIN : sum;
        least = low < least ? low : least;
        most = high > most ? high : most;
    }
    return {least, most};
}

PELAGE_LEVELS
std::int64_t sum_of_charges(const std::int32_t *__restrict xs, const std::int32_t *__restrict ys, std::size_t count,
                            std::int32_t x, std::int32_t y) {
    std::int64_t sum = 0;
#pragma omp simd reduction(+ : sum)
    for (std::size_t i = 0; i < count; ++i) sum += inverse_in_parts(xs[i] - x, ys[i] - y);
    return sum;
}

// t^eta in parts of 2^38 for 0 < t <= 1: logarithm and power to the base of 2, as the reference's.
PELAGE_WITHIN std::int64_t weight_of(float share, float eta) {
    const std::int32_t bits = bits_of(share);
    const std::int32_t exponent = (bits - 0x3f3504f3) >> 23;
    const float t = of_bits(bits - exponent * 0x800000) - 1.0f;
    float p = 0x1.01b6c6p-3f;
    p = p * t + -0x1.a87d02p-3f;
    p = p * t + 0x1.b9c91cp-3f;
    p = p * t + -0x1.e95be8p-3f;
    p = p * t + 0x1.26d384p-2f;
    p = p * t + -0x1.715c4ep-2f;
    p = p * t + 0x1.ec73d6p-2f;
    p = p * t + -0x1.71547p-1f;
    p = p * t + 0x1.715476p+0f;
    const float power = eta * (p * t + static_cast<float>(exponent));
    const float held = power < -60.0f ? -60.0f : power;
    const float shifted = held + 0x1.8p+23f;
    const float f = held - (shifted - 0x1.8p+23f);
    float q = 0x1.5c08e4p-10f;
    q = q * f + 0x1.3d0c52p-7f;
    q = q * f + 0x1.c6b6e4p-5f;
    q = q * f + 0x1.ebf918p-3f;
    q = q * f + 0x1.62e428p-1f;
    q = q * f + 0x1.000002p+0f;
    const std::int32_t found =
        bits_of(q) + static_cast<std::int32_t>(static_cast<std::uint32_t>(bits_of(shifted)) << 23);
    return static_cast<std::int64_t>(of_bits(found) * 0x1p38f);
}

PELAGE_LEVELS
std::uint64_t weigh(const CandidateArrays &of, std::size_t begin, std::size_t end, const WeightNumbers &numbers,
                    std::uint64_t *__restrict weights) {
    const std::int32_t *__restrict xs = of.x;
    const std::int64_t *__restrict sums = of.sums;
    const std::int64_t most = numbers.most, down = numbers.down;
    const float scale = numbers.scale, eta = numbers.eta;
    std::uint64_t total = 0;
#pragma omp simd reduction(+ : total)
    for (std::size_t i = begin; i < end; ++i) {
        const auto below = static_cast<std::int32_t>((most - sums[i]) >> down);
        const std::int64_t found = weight_of(static_cast<float>(below) * scale, eta);
        const std::int64_t weight = below == 0 || xs[i] < 0 ? 0 : found;
        weights[i - begin] = static_cast<std::uint64_t>(weight);
        total += static_cast<std::uint64_t>(weight);
    }
    return total;
}

}  // namespace pelage::bench
