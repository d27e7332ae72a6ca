// Reinforcement: M. Malheiros, H. Fensterseifer and M. Walter, "The leopard never changes its spots" (2020):
// dc/dt = (t - w - c)(t - c)(t + w - c) 3 sqrt(3) / (2 w^2), with stable states t - w and t + w around the threshold t.
#pragma once

namespace pelage::reference {

struct Reinforcement {
    template <class T, class P>
    static T flow(T c, const P& p) {
        const T t = p[0], w = p[1];
        const T g = T(2.598076211353316) / (w * w);  // 3 sqrt(3) / 2: the fastest change equals the width
        return ((((t - w) - c) * (t - c)) * ((t + w) - c)) * g;
    }
};

}  // namespace pelage::reference
