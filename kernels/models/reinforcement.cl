//@ model reinforcement | u 3.5 to 6.5 | threshold 0.5 to 5, width 0.125 to 3
// Pattern reinforcement (Malheiros, Fensterseifer & Walter 2020): f = (t - w - u) (t - u) (t + w - u) g, with
// g = 3 sqrt(3) / (2 w^2); t the threshold, w the width.

#ifdef PELAGE_DOUBLE
#define REINFORCEMENT_GAIN 0x1.4c8dc2e423980p+1
#else
#define REINFORCEMENT_GAIN 0x1.4c8dc2p+1f  // 3 sqrt(3) / 2
#endif

static inline real reinforcement_u(real n, real s, real dt, real u, real t, real w) {
    const real g = R(REINFORCEMENT_GAIN) / (w * w);
    return ADD_REACTION(n, s, ((((t - w) - u) * (t - u)) * ((t + w) - u)) * g, dt);
}
