// Division that rounds up: how many parts cover a whole.
#pragma once

#include <cstddef>

namespace pelage {

inline std::size_t divided(std::size_t a, std::size_t b) { return (a + b - 1) / b; }

}  // namespace pelage
