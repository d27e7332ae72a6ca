// The reaction of A. M. Turing, "The chemical basis of morphogenesis" (1952), as M. Malheiros and M. Walter use it in
// "Pattern formation through minimalist biologically inspired cellular simulation" (2017):
// du/dt = alpha - u v, dv/dt = u v - v - beta.
// Fixed point u = v = 4 for alpha = 16, beta = 12.
#pragma once

#include "reference/rules/flow.hpp"

#include <cstddef>
#include <string_view>

namespace pelage::reference {

struct Turing {
    static constexpr std::string_view word = "turing";
    static constexpr std::size_t species = 2;
    static constexpr std::size_t parameters = 2;

    template <class T, class P>
    static Flow<T, 2> flow(T u, T v, const P& p) {
        const T alpha = p[0], beta = p[1];
        const T uv = u * v;
        return {alpha - uv, (uv - v) - beta};
    }
};

}  // namespace pelage::reference
