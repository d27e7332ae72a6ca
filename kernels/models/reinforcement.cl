// Pattern reinforcement (Malheiros, Fensterseifer & Walter 2020): f = (t - w - c) (t - c) (t + w - c) g, with
// g = 3 sqrt(3) / (2 w^2); t the threshold, w the width.

#ifdef PELAGE_DOUBLE
#define REINFORCEMENT_GAIN 0x1.4c8dc2e423980p+1
#else
#define REINFORCEMENT_GAIN 0x1.4c8dc2p+1f  // 3 sqrt(3) / 2
#endif

static inline real reinforcement_u(real n, real s, real dt, real c, real t, real w) {
    const real g = R(REINFORCEMENT_GAIN) / (w * w);
    return ADD_REACTION(n, s, ((((t - w) - c) * (t - c)) * ((t + w) - c)) * g, dt);
}
