// Arguments at which elementary functions are compared.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pelage::verify {

// Columns of equal length; those that a function does not take are as long and of no account.
template <class T>
using Arguments = std::array<std::vector<T>, 3>;

// `count` tuples: numbers at which functions have something special, numbers of all sizes, and numbers of the sizes
// that experiments have. `narrow` leaves out numbers nearer to 0 than 2^-60 and farther than 2^60, for devices that
// do not take subnormal numbers for 0. `more`: other numbers at which this function has something special.
template <class T>
Arguments<T> drawn_arguments(std::size_t parameters, std::size_t count, std::uint64_t seed, bool narrow,
                             const std::vector<double>& more = {});

}  // namespace pelage::verify
