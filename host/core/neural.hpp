// The numbers of a neural reaction: a small network that every cell asks how its chemicals change.
// A. Mordvintsev, E. Randazzo and E. Niklasson, "Differentiable Programming of Chemical Reaction-Diffusion" (2021).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace pelage {

inline constexpr std::size_t chemical_groups = 4;  // each diffuses twice as fast as the one before
inline constexpr std::size_t largest_network_chemicals = 64;
inline constexpr std::size_t largest_hidden = 256;
inline constexpr std::size_t hidden_block = 8;  // hidden values are computed so many at a time

// f(x) = act(x W0 + b0) W1 with act(z) = z sigmoid(5 z).
struct Network {
    std::size_t chemicals = 0;   // a multiple of chemical_groups
    std::size_t hidden = 0;      // a multiple of hidden_block
    std::vector<double> first;   // W0, [chemical][hidden]
    std::vector<double> bias;    // b0, [hidden]
    std::vector<double> second;  // W1, [hidden][chemical]
};

// Hidden values whose weights are all 0 fill up the last block: they change nothing. Throws Error where the numbers of
// weights do not fit each other or a limit above, or where one is not finite in float. `name` is for messages.
Network make_network(std::size_t chemicals, std::size_t hidden, const std::vector<double>& first,
                     const std::vector<double>& bias, const std::vector<double>& second, const std::string& name);

// How fast chemical `place` of a network's `chemicals` diffuses: 1/8, 1/4, 1/2 and 1, each for a quarter of them.
double group_rate(std::size_t place, std::size_t chemicals);

}  // namespace pelage
