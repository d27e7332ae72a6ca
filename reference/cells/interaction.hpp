// What the neighbours of a free cell do to it: diffusion, gradient and collision.
#pragma once

#include "core/neighbours.hpp"
#include "reference/rules/state.hpp"

#include <cstdint>
#include <vector>

namespace pelage::reference {

// What stays the same for all cells of one iteration.
template <class T>
struct Interaction {
    T dt{};
    std::vector<std::uint8_t> diffuses;     // [chemical]; 0: its rate is 0 in every cell and for good
    std::vector<std::uint8_t> anisotropic;  // [chemical]
    bool exact = true;  // neighbours lists candidates that may be too far; otherwise all of them count
};

// Adds to `next` what every cell receives from its neighbours in `old`: concentrations, position and the count of
// neighbours; where polarize[cell] >= 0 also the polarity, unit gradient of that chemical where it is steep enough.
template <class T>
void interact(const Interaction<T>&, const Neighbours&, const std::vector<std::int32_t>& polarize, const State<T>& old,
              State<T>& next);

}  // namespace pelage::reference
