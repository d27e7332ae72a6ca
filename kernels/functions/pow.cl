//@ function pow x, y | needs logarithm, quotient, power
// e^(y ln x), with ln x to half as many bits again as a number has: with s = (m - 1) / (m + 1), ln m = 2 s + s^3 (2/3 + ...).

// (ln m - 2 s - 2/3 s^3) / s^5 of z = s^2, for m from sqrt(1/2) to sqrt(2): minimax.
static inline real pelage_pow_tail(real z) {
#ifdef PELAGE_DOUBLE
    real p = R(0x1.eacd52ec57d83p-4);
    p = fma(p, z, R(0x1.de3ca9d11d6p-4));
    p = fma(p, z, R(0x1.11207325d4d45p-3));
    p = fma(p, z, R(0x1.3b1364b59a6a1p-3));
    p = fma(p, z, R(0x1.745d182985acfp-3));
    p = fma(p, z, R(0x1.c71c71c596643p-3));
    p = fma(p, z, R(0x1.2492492492f51p-2));
    p = fma(p, z, R(0x1.9999999999996p-2));
#else
    real p = R(0x1.dfa3b4p-3f);
    p = fma(p, z, R(0x1.245278p-2f));
    p = fma(p, z, R(0x1.999ap-2f));
#endif
    return p;
}

// ln x of positive normal x.
static inline struct pelage_pair pelage_long_log(real x) {
    const struct pelage_parts parts = pelage_parts_around_one(x);
    struct pelage_pair n;
    n.high = parts.mantissa - R(1);
    n.low = R(0);
    const struct pelage_pair s = pelage_quotient(n, pelage_sum(parts.mantissa, R(1)));
    struct pelage_pair z = pelage_product(s.high, s.high);
    z.low = fma(R(2) * s.high, s.low, z.low);
    // w = 2/3 + z tail, v = z w, t = s v
    struct pelage_pair w = pelage_quick_sum(PICK(0x1.555556p-1f, 0x1.5555555555555p-1), z.high * pelage_pow_tail(z.high));
    w.low += PICK(-0x1.555556p-26f, 0x1.5555555555555p-55);
    struct pelage_pair v = pelage_product(z.high, w.high);
    v.low += fma(z.high, w.low, z.low * w.high);
    struct pelage_pair t = pelage_product(s.high, v.high);
    t.low += fma(s.high, v.low, s.low * v.high);
    const struct pelage_pair twice = pelage_quick_sum(R(2) * s.high, t.high);
    const struct pelage_pair all = pelage_quick_sum(parts.exponent * LN2_HIGH, twice.high);
    const real low = fma(R(2), s.low, t.low) + twice.low;
    return pelage_quick_sum(all.high, all.low + fma(parts.exponent, LN2_LOW, low));
}

// |x|^y of |x| and y that are no NaN; |x| may be 0 or infinite, and so may y.
static inline real pelage_pow_size(real size, real y) {
    struct pelage_pair log = pelage_long_log(size);
    const mask ends = (size == R(0)) | (size == INFINITE);
    log.high = SELECT(size == R(0), -INFINITE, SELECT(size == INFINITE, INFINITE, log.high));
    struct pelage_pair p = pelage_product(y, log.high);
    p.low = fma(y, log.low, p.low);
    const real bound = PICK(150.0f, 1100.0);
    const mask within = pelage_size(p.high) < bound;
    const struct pelage_power power = pelage_power(HELD(p.high, -bound, bound), SELECT(within & !ends, p.low, R(0)));
    const struct pelage_pair value = pelage_one_more(power.more);
    return pelage_scaled(value.high + value.low, power.exponent);
}

// The special values are those of C (annex F).
static inline real pelage_pow(real x, real y) {
    x = pelage_flushed(x);
    y = pelage_flushed(y);
    const real size = pelage_size(x);
    const mask whole = rint(y) == y;
    const mask odd = whole & (rint(R(0.5f) * y) != R(0.5f) * y);
    const real found = pelage_signed(pelage_pow_size(size, y), SELECT(odd, pelage_sign(x), WORD(0u, 0ul)));
    const mask no_power = (x < R(0)) & (size < INFINITE) & !whole;
    const real known = SELECT((x != x) | (y != y), x + y, SELECT(no_power, R(NAN), found));
    const mask is_one = (x == R(1)) | (y == R(0)) | ((x == R(-1)) & (pelage_size(y) == INFINITE));
    return SELECT(is_one, R(1), known);
}
