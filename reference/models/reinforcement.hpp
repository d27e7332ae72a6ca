// Reinforcement: M. Malheiros, H. Fensterseifer and M. Walter, "The leopard never changes its spots" (2020):
// du/dt = (t - w - u)(t - u)(t + w - u) 3 sqrt(3) / (2 w^2), with stable states t - w and t + w around the threshold t.
#pragma once

#include "reference/rules/flow.hpp"

#include <cstddef>
#include <string_view>

namespace pelage::reference {

struct Reinforcement {
    static constexpr std::string_view word = "reinforcement";
    static constexpr std::size_t species = 1;
    static constexpr std::size_t parameters = 2;

    template <class T, class P>
    static Flow<T, 1> flow(T u, const P& p) {
        const T t = p[0], w = p[1];
        const T g = T(2.598076211353316) / (w * w);  // 3 sqrt(3) / 2: the fastest change equals the width
        return {((((t - w) - u) * (t - u)) * ((t + w) - u)) * g};
    }
};

}  // namespace pelage::reference
