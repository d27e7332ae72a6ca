// Turing's nonlinear system: f = alpha - u v, g = u v - v - beta.

static inline real turing_u(real n, real s, real dt, real u, real v, real alpha, real beta) {
    return ADD_REACTION(n, s, alpha - u * v, dt);
}

static inline real turing_v(real n, real s, real dt, real u, real v, real alpha, real beta) {
    return ADD_REACTION(n, s, ((u * v) - v) - beta, dt);
}
