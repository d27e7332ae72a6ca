//@ model gm1 | u 0.5 to 1.5, v 0.75 to 1.25 | a 0 to 0.25, b 0.25 to 1, c 0 to 0.5
// Gierer-Meinhardt activator-inhibitor: f = a - b u + u^2 / (v (1 + c u^2)), g = u^2 - v.

static inline real gm1_u(real n, real s, real dt, real u, real v, real a, real b, real c) {
    return ADD_REACTION(n, s, (a - b * u) + ((u * u) / (v * (R(1) + ((c * u) * u)))), dt);
}

static inline real gm1_v(real n, real s, real dt, real u, real v, real a, real b, real c) {
    return ADD_REACTION(n, s, u * u - v, dt);
}
