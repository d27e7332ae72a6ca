// Linear activator and inhibitor with bounded production: S. Kondo and R. Asai, "A reaction-diffusion wave on the skin
// of the marine angelfish Pomacanthus" (1995): du/dt = clamp(au u + bu v + cu, 0, mu) - du u, and v alike.
#pragma once

#include "reference/rules/flow.hpp"

#include <cstddef>
#include <string_view>

namespace pelage::reference {

struct Linear {
    static constexpr std::string_view word = "linear";
    static constexpr std::size_t species = 2;
    static constexpr std::size_t parameters = 10;

    template <class T, class P>
    static Flow<T, 2> flow(T u, T v, const P& p) {
        const T production_u = produced(u, v, T(p[0]), T(p[1]), T(p[2]), T(p[4]));
        const T production_v = produced(u, v, T(p[5]), T(p[6]), T(p[7]), T(p[9]));
        return {production_u - T(p[3]) * u, production_v - T(p[8]) * v};
    }

private:
    template <class T>
    static T produced(T u, T v, T a, T b, T c, T most) {
        const T s = ((a * u) + (b * v)) + c;
        return s < T(0) ? T(0) : s > most ? most : s;
    }
};

}  // namespace pelage::reference
