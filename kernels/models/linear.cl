//@ model linear | u 1 to 5, v 1 to 5 | au -1 to 1, bu -1 to 1, cu 0 to 0.5, du 0 to 1, mu 0 to 1, av -1 to 1, bv -1 to 1, cv 0 to 0.5, dv 0 to 1, mv 0 to 1
// Kondo & Asai's linear system: production a u + b v + c held in [0, m], less decay d.

static inline real pelage_linear(real n, real s, real dt, real u, real v, real own, real a, real b, real c, real d, real m) {
    const real sum = ((a * u) + (b * v)) + c;
    const real production = SELECT(sum < R(0), R(0), SELECT(sum > m, m, sum));
    return ADD_REACTION(n, s, production - d * own, dt);
}

static inline real linear_u(real n, real s, real dt, real u, real v, real au, real bu, real cu, real du, real mu, real av,
                            real bv, real cv, real dv, real mv) {
    return pelage_linear(n, s, dt, u, v, u, au, bu, cu, du, mu);
}

static inline real linear_v(real n, real s, real dt, real u, real v, real au, real bu, real cu, real du, real mu, real av,
                            real bv, real cv, real dv, real mv) {
    return pelage_linear(n, s, dt, u, v, v, av, bv, cv, dv, mv);
}
