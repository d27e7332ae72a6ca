//@ part | needs numbers
// Quotients and square roots as pairs, from a first guess by the bits and steps of third order.

// 1 / d for d between 2^-60 and 2^60, by so many steps, each of which makes the error its cube.
static inline real pelage_reciprocal_by(int steps, real d) {
    real y = AS_NUMBER(WORD(0x7ef311c7u, 0x7fde6238da3c2118ul) - AS_BITS(d));
    for (int step = 0; step < steps; ++step) {
        const real e = fma(-d, y, R(1));
        y = fma(y, fma(e, e, e), y);
    }
    return y;
}

// To a few units of the last place.
static inline real pelage_reciprocal(real d) { return pelage_reciprocal_by(3, d); }

// The same with a step less where float needs none more.
static inline real pelage_quick_reciprocal(real d) {
#ifdef PELAGE_DOUBLE
    return pelage_reciprocal_by(3, d);
#else
    return pelage_reciprocal_by(2, d);
#endif
}

// n / d for positive d between 2^-60 and 2^60.
static inline struct pelage_pair pelage_quotient(struct pelage_pair n, struct pelage_pair d) {
    const real y = pelage_reciprocal(d.high);
    struct pelage_pair q;
    q.high = n.high * y;
    const real rest = fma(-q.high, d.high, n.high);
    q.low = (fma(-q.high, d.low, rest) + n.low) * y;
    return q;
}

// The square root of s between 2^-120 and 2^120, or 0.
static inline struct pelage_pair pelage_root(struct pelage_pair s) {
    real y = AS_NUMBER(WORD(0x5f3759dfu, 0x5fe6eb50c7b537a9ul) - (AS_BITS(s.high) >> 1));
    for (int step = 0; step < 3; ++step) {
        const real e = fma(-(s.high * y), y, R(1));
        y = fma(y, e * fma(e, R(0.375f), R(0.5f)), y);
    }
    struct pelage_pair root;
    root.high = s.high * y;
    root.low = (fma(-root.high, root.high, s.high) + s.low) * (R(0.5f) * y);
    return root;
}
