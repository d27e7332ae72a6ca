//@ function sinh x | needs steep

// (sinh(x) - x) / x^3 of z = x^2, |x| < 0.35: minimax.
static inline real pelage_sinh_tail(real z) {
#ifdef PELAGE_DOUBLE
    real p = R(0x1.7233dc399a405p-33);
    p = fma(p, z, R(0x1.ae5791f4b37b3p-26));
    p = fma(p, z, R(0x1.71de3e019cf92p-19));
    p = fma(p, z, R(0x1.a01a019f1d212p-13));
    p = fma(p, z, R(0x1.1111111111301p-7));
    p = fma(p, z, R(0x1.5555555555555p-3));
#else
    real p = R(0x1.a28956p-13f);
    p = fma(p, z, R(0x1.110fe4p-7f));
    p = fma(p, z, R(0x1.555556p-3f));
#endif
    return p;
}

static inline real pelage_sinh(real x) {
    x = pelage_flushed(x);
    const real size = pelage_size(x);
    const struct pelage_powers powers = pelage_powers(size, SIGN_BIT);
    const real z = size * size;
    const real near = fma(z * size, pelage_sinh_tail(z), size);
    const real found = SELECT(size < R(0.34375f), near, pelage_scaled(powers.value, powers.exponent - R(1)));
    return pelage_signed(found, pelage_sign(x));
}
