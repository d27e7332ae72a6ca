// A neural reaction: the network of a rule, asked for every cell, and the diffusion that belongs to it.
#pragma once

#include "core/neural.hpp"

#include <cstddef>
#include <vector>

namespace pelage::reference {

// f[chemical][cell] = (act(x W0 + b0) W1) of x[chemical][cell], act(z) = z sigmoid(5 z). Every sum begins at b0, or at
// 0, and goes on with fma in the order of the rows of its matrix.
template <class T>
std::vector<std::vector<T>> ask(const Network&, const std::vector<const T*>& x, std::size_t cells);

}  // namespace pelage::reference
