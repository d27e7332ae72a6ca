// Long sums in the order that core/learning.hpp gives them.
#pragma once

#include <cstddef>

namespace pelage::reference {

// `count`, a power of two, partial sums become one.
template <class T>
T folded(T* lanes, std::size_t count) {
    for (std::size_t half = count / 2; half > 0; half /= 2) {
        for (std::size_t lane = 0; lane < half; ++lane) lanes[lane] = lanes[lane] + lanes[lane + half];
    }
    return lanes[0];
}

}  // namespace pelage::reference
