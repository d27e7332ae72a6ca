// The seed that checks take unless another one is asked for.
#pragma once

#include <cstdint>

namespace pelage::verify {

inline constexpr std::uint64_t usual_seed = 1;

}  // namespace pelage::verify
