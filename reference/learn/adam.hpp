// The optimiser: D. Kingma and J. Ba, "Adam: A method for stochastic optimization" (2015), algorithm 1.
#pragma once

#include "core/learning.hpp"

#include <cstdint>
#include <vector>

namespace pelage::reference {

// One step of the weights against the slopes, each of the three arrays of which is brought to length 1 first. `count`:
// which step it is, from 1.
template <class T>
void adam(const LearningShape&, std::vector<T> slopes, double rate, std::uint64_t count, Learned<T>&);

}  // namespace pelage::reference
