// See frame_loops.hpp. Compiled once for each level of x86-64, one of which is chosen when the program starts; that
// changes no value.
#include "io/frame_loops.hpp"

#include <limits>

// ThreadSanitizer has not begun when the choice is made, and would break it.
#if defined(__x86_64__) && defined(__gnu_linux__) && !defined(__SANITIZE_THREAD__)
#define PELAGE_LEVELS __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define PELAGE_LEVELS
#endif
#define PELAGE_WITHIN inline __attribute__((always_inline))

namespace pelage {

namespace {

template <class Number>
PELAGE_WITHIN std::int32_t place_of(float at, const Placing<Number>& by) {
    const Number value = at;
    Number place = (value - by.low) * by.scale + 1;
    place = place > 0 ? place : 0;
    place = place < by.top ? place : by.top;
    place = value == value ? place : by.of_nan;
    return static_cast<std::int32_t>(place);
}

// Of the sum of four words: two is added to each part, and the parts are divided by four.
PELAGE_WITHIN std::uint32_t quarter(std::uint32_t sum) {
    constexpr std::uint32_t two = 2U << high_part | 2U << middle_part | 2U << low_part;
    constexpr std::uint32_t bytes = 255U << high_part | 255U << middle_part | 255U << low_part;
    return (sum + two) >> 2 & bytes;
}

PELAGE_WITHIN std::uint32_t sum_of_four(const std::uint32_t* above, const std::uint32_t* below, std::size_t i) {
    return above[2 * i] + above[2 * i + 1] + below[2 * i] + below[2 * i + 1];
}

// In 1/65536; a half is added to each.
PELAGE_WITHIN std::uint32_t yuv_of(std::uint32_t rgb) {
    const auto part = [&](int place) { return static_cast<int>(rgb >> place & 255U); };
    const int r = part(high_part), g = part(middle_part), b = part(low_part);
    const int bright = 11966 * r + 40254 * g + 4064 * b + (16 << 16) + (1 << 15);
    const int blue = 28784 * b - 6596 * r - 22188 * g + (128 << 16) + (1 << 15);
    const int red = 28784 * r - 26145 * g - 2639 * b + (128 << 16) + (1 << 15);
    const auto whole = [](int sum) { return static_cast<std::uint32_t>(sum >> 16); };
    return whole(bright) << high_part | whole(red) << middle_part | whole(blue) << low_part;
}

}  // namespace

PELAGE_LEVELS
void find_places(const float* values, std::size_t count, const Placing<float>& by, std::int32_t* places) {
    const Placing<float> placing = by;
    for (std::size_t i = 0; i < count; ++i) places[i] = place_of(values[i], placing);
}

PELAGE_LEVELS
void find_places(const float* values, std::size_t count, const Placing<double>& by, std::int32_t* places) {
    const Placing<double> placing = by;
    for (std::size_t i = 0; i < count; ++i) places[i] = place_of(values[i], placing);
}

PELAGE_LEVELS
std::uint32_t look_up_words(const std::uint32_t* table, const std::int32_t* places, std::size_t count,
                            std::uint32_t* __restrict to) {
    std::uint32_t seen = 0;
    for (std::size_t i = 0; i < count; ++i) {
        to[i] = table[places[i]];
        seen |= to[i];
    }
    return seen;
}

PELAGE_LEVELS
void widen_lanes(const float* values, std::size_t rounds, float* __restrict low, float* __restrict high) {
    constexpr float infinite = std::numeric_limits<float>::infinity();
    for (std::size_t round = 0; round < rounds; ++round) {
        const float* row = values + round * finite_lanes;
        for (std::size_t lane = 0; lane < finite_lanes; ++lane) {
            const float value = row[lane];
            const float from_below = value > -infinite ? value : infinite;  // a NaN: too
            const float from_above = value < infinite ? value : -infinite;
            low[lane] = from_below < low[lane] ? from_below : low[lane];
            high[lane] = from_above > high[lane] ? from_above : high[lane];
        }
    }
}

PELAGE_LEVELS
void take_high_parts(const std::uint32_t* words, std::size_t count, std::uint8_t* __restrict to) {
    for (std::size_t i = 0; i < count; ++i) to[i] = static_cast<std::uint8_t>(words[i] >> high_part);
}

PELAGE_LEVELS
void mean_words(const std::uint32_t* above, const std::uint32_t* below, std::size_t count,
                std::uint32_t* __restrict to) {
    for (std::size_t i = 0; i < count; ++i) to[i] = quarter(sum_of_four(above, below, i));
}

PELAGE_LEVELS
void mean_parts(const std::uint32_t* above, const std::uint32_t* below, std::size_t count, std::uint8_t* __restrict low,
                std::uint8_t* __restrict middle) {
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t mean = quarter(sum_of_four(above, below, i));
        low[i] = static_cast<std::uint8_t>(mean >> low_part);
        middle[i] = static_cast<std::uint8_t>(mean >> middle_part);
    }
}

PELAGE_LEVELS
void to_yuv(const std::uint32_t* rgb, std::size_t count, std::uint32_t* to) {
    for (std::size_t i = 0; i < count; ++i) to[i] = yuv_of(rgb[i]);
}

}  // namespace pelage
