// A cubic in one chemical, the kinetics of the Schlögl and Nagumo equations: du/dt = (u - a)(u - b)(u - c).
#pragma once

#include "reference/rules/flow.hpp"

#include <cstddef>
#include <string_view>

namespace pelage::reference {

struct Cubic {
    static constexpr std::string_view word = "cubic";
    static constexpr std::size_t species = 2;
    static constexpr std::size_t parameters = 3;

    template <class T, class P>
    static Flow<T, 1> flow(T u, T, const P& p) {
        const T a = p[0], b = p[1], c = p[2];
        return {((u - a) * (u - b)) * (u - c)};
    }

    // The published program multiplies by the scale first.
    template <class T, class P>
    static Flow<T, 1> scaled_flow(T scale, T u, T, const P& p) {
        const T a = p[0], b = p[1], c = p[2];
        return {((scale * (u - a)) * (u - b)) * (u - c)};
    }
};

}  // namespace pelage::reference
