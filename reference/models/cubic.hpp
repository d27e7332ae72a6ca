// A cubic in one chemical, the kinetics of the Schlögl and Nagumo equations: du/dt = (u - a)(u - b)(u - c).
#pragma once

#include "reference/models/flow.hpp"

namespace pelage::reference {

struct Cubic {
    template <class T, class P>
    static T flow(T u, const P& p) {
        const T a = p[0], b = p[1], c = p[2];
        return ((u - a) * (u - b)) * (u - c);
    }

    // The published program multiplies by the scale first.
    template <class T, class P>
    static T scaled_flow(T scale, T u, const P& p) {
        const T a = p[0], b = p[1], c = p[2];
        return ((scale * (u - a)) * (u - b)) * (u - c);
    }
};

}  // namespace pelage::reference
