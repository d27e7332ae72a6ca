//@ model gray-scott | u 0.5 to 1, v 0.05 to 0.45 | f 0 to 0.125, k 0 to 0.125
// Gray-Scott: f = -u v^2 + feed (1 - u), g = u v^2 - (feed + kill) v.

static inline real gray_scott_u(real n, real s, real dt, real u, real v, real feed, real kill) {
    const real uvv = (u * v) * v;
#ifdef PELAGE_PUBLISHED
    const real f = (-uvv) + (feed * (R(1) - u));
#else
    const real f = fma(feed, R(1) - u, -uvv);
#endif
    return ADD_REACTION(n, s, f, dt);
}

static inline real gray_scott_v(real n, real s, real dt, real u, real v, real feed, real kill) {
    const real uvv = (u * v) * v;
#ifdef PELAGE_PUBLISHED
    const real g = uvv - ((feed + kill) * v);
#else
    const real g = fma(-(feed + kill), v, uvv);
#endif
    return ADD_REACTION(n, s, g, dt);
}
