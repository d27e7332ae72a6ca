// Counter-based random numbers: Philox4x32-10 (Salmon, Moraes, Dror & Shaw 2011).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace pelage {

std::array<std::uint32_t, 4> philox4x32_10(std::array<std::uint32_t, 4> counter, std::array<std::uint32_t, 2> key);

// What a draw is for: the fourth word of the counter. The counter is (cell, iteration, rule, purpose), the key is
// (low, high) word of the seed; `rule` is the rule's place in Experiment::rules, from 0.
namespace purpose {
inline constexpr std::uint32_t condition = 0;  // Probability
inline constexpr std::uint32_t deviation = 1;  // Change, Divide, Move
inline constexpr std::uint32_t operand =
    2;  // RANDOM; the n-th of one rule (from 0) uses word n % 4 of operand + 16 * (n / 4)
inline constexpr std::uint32_t expansion = 3;
// RANDOM outside rules, counted as in rules; in place of the rule stands that of the field, the statement or the
// picture.
inline constexpr std::uint32_t field = 4;
inline constexpr std::uint32_t start = 5;
inline constexpr std::uint32_t output = 6;
inline constexpr std::uint32_t parameter = 7;    // in place of the cell stands that of the parameter
inline constexpr std::uint32_t aggregation = 8;  // in place of the cell stands 0
inline constexpr std::uint32_t charge_size = 9;  // RANDOM; in place of the cell stands the iteration
}  // namespace purpose

// The words of one draw.
std::array<std::uint32_t, 4> counted_words(std::size_t cell, std::uint64_t iteration, std::size_t rule,
                                           std::uint32_t purpose, std::int64_t seed);

// Uniform in [0, 1) from the upper 24 bits: exact in float and double alike.
template <class T>
T unit_uniform(std::uint32_t word) {
    return static_cast<T>(word >> 8) * static_cast<T>(0x1p-24);
}

}  // namespace pelage
