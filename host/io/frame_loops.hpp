// The loops over pixels that a film's time goes into.
#pragma once

#include <cstddef>
#include <cstdint>

namespace pelage {

// How values become places in a table: (value - low) * scale + 1, at least 0 and at most `top`; of a NaN, `of_nan`.
template <class Number>
struct Placing {
    Number low = 0;
    Number scale = 1;
    Number top = 0;
    Number of_nan = 0;
};

void find_places(const float* values, std::size_t count, const Placing<float>&, std::int32_t* places);
void find_places(const float* values, std::size_t count, const Placing<double>&, std::int32_t* places);

// The words at these places; returns all of them, or-ed.
std::uint32_t look_up_words(const std::uint32_t* table, const std::int32_t* places, std::size_t count,
                            std::uint32_t* to);

// Widens each lane's range by the finite ones among its values: value i is of lane i % finite_lanes.
inline constexpr std::size_t finite_lanes = 16;
void widen_lanes(const float* values, std::size_t rounds, float* low, float* high);

// Words have three parts of ten bits, each a byte and two bits of room.
inline constexpr int low_part = 0, middle_part = 10, high_part = 20;

// The high parts of words.
void take_high_parts(const std::uint32_t* words, std::size_t count, std::uint8_t* to);

// Part by part the mean, rounded, of every 2 x 2 words of two lines: as words, and those of the low and middle parts.
void mean_words(const std::uint32_t* above, const std::uint32_t* below, std::size_t count, std::uint32_t* to);
void mean_parts(const std::uint32_t* above, const std::uint32_t* below, std::size_t count, std::uint8_t* low,
                std::uint8_t* middle);

// Red, green and blue as three parts to brightness (16 to 235) and colour differences (16 to 240, blue's the low part)
// by ITU-R BT.709. Both may be the same array.
void to_yuv(const std::uint32_t* rgb, std::size_t count, std::uint32_t* to);

}  // namespace pelage
