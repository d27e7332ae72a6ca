// A. Gierer and H. Meinhardt, "A theory of biological pattern formation" (1972), with saturation:
// du/dt = a - b u + u^2 / (v (1 + c u^2)), dv/dt = u^2 - v.
#pragma once

#include "reference/rules/flow.hpp"

#include <cstddef>
#include <string_view>

namespace pelage::reference {

struct Gm1 {
    static constexpr std::string_view word = "gm1";
    static constexpr std::size_t species = 2;
    static constexpr std::size_t parameters = 3;

    template <class T, class P>
    static Flow<T, 2> flow(T u, T v, const P& p) {
        const T a = p[0], b = p[1], c = p[2];
        const T uu = u * u;
        return {(a - b * u) + (uu / (v * (T(1) + ((c * u) * u)))), uu - v};
    }
};

}  // namespace pelage::reference
