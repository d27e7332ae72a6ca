//@ model turing | u 3.5 to 4.5, v 3.5 to 4.5 | alpha 2 to 18, beta 0 to 14
// Turing's nonlinear system: f = alpha - u v, g = u v - v - beta.

static inline real turing_u(real n, real s, real dt, real u, real v, real alpha, real beta) {
    return ADD_REACTION(n, s, alpha - u * v, dt);
}

static inline real turing_v(real n, real s, real dt, real u, real v, real alpha, real beta) {
    return ADD_REACTION(n, s, ((u * v) - v) - beta, dt);
}
