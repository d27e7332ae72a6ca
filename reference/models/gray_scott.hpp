// P. Gray and S. K. Scott's autocatalysis (1984) as J. E. Pearson simulated it, "Complex patterns in a simple system"
// (1993): du/dt = -u v^2 + f (1 - u), dv/dt = u v^2 - (f + k) v. Fixed point u = 1, v = 0.
#pragma once

#include "reference/rules/flow.hpp"

#include <cmath>
#include <cstddef>
#include <string_view>

namespace pelage::reference {

struct GrayScott {
    static constexpr std::string_view word = "gray-scott";
    static constexpr std::size_t species = 2;
    static constexpr std::size_t parameters = 2;

    template <class T, class P>
    static Flow<T, 2> flow(T u, T v, const P& p) {
        const T f = p[0], k = p[1];
        const T uvv = (u * v) * v;
        return {(-uvv) + (f * (T(1) - u)), uvv - ((f + k) * v)};
    }

    template <class T, class P>
    static Flow<T, 2> fused_flow(T u, T v, const P& p) {
        const T f = p[0], k = p[1];
        const T uvv = (u * v) * v;
        return {std::fma(f, T(1) - u, -uvv), std::fma(-(f + k), v, uvv)};
    }
};

}  // namespace pelage::reference
