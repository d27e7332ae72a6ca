//@ model cubic | u 2 to 3, v 0 to 1 kept | a 0 to 4, b 0 to 4, c 0 to 4
// Three roots, the outer ones drawing u on: f = (u - a) (u - b) (u - c).

static inline real cubic_u(real n, real s, real dt, real u, real v, real a, real b, real c) {
#ifdef PELAGE_PUBLISHED
    return n + ((((s * (u - a)) * (u - b)) * (u - c)) * dt);
#else
    return ADD_REACTION(n, s, ((u - a) * (u - b)) * (u - c), dt);
#endif
}
