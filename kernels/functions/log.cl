//@ function log x | needs logarithm

// (ln(1 + f) - f + f^2 / 2) / f^3 for 1 + f from sqrt(1/2) to sqrt(2): minimax.
static inline real pelage_log_tail(real f) {
#ifdef PELAGE_DOUBLE
    real p = R(-0x1.8ddb05e2d0df1p-6);
    p = fma(p, f, R(0x1.d2cc4d117becp-5));
    p = fma(p, f, R(-0x1.010d2e7e23f6fp-4));
    p = fma(p, f, R(0x1.bba6f5122e00cp-5));
    p = fma(p, f, R(-0x1.b458879474025p-5));
    p = fma(p, f, R(0x1.dc97995339e7p-5));
    p = fma(p, f, R(-0x1.00d0224367691p-4));
    p = fma(p, f, R(0x1.116a13e6b76b2p-4));
    p = fma(p, f, R(-0x1.2489416823eddp-4));
    p = fma(p, f, R(0x1.3b0d7659a70bdp-4));
    p = fma(p, f, R(-0x1.5555773c18521p-4));
    p = fma(p, f, R(0x1.745d58f6c70fcp-4));
    p = fma(p, f, R(-0x1.99999a9cfd606p-4));
    p = fma(p, f, R(0x1.c71c702cd4f0cp-4));
    p = fma(p, f, R(-0x1.fffffff3b54b2p-4));
    p = fma(p, f, R(0x1.249249276077ep-3));
    p = fma(p, f, R(-0x1.555555556b0e1p-3));
    p = fma(p, f, R(0x1.9999999994d48p-3));
    p = fma(p, f, R(-0x1.ffffffffffe7cp-3));
    p = fma(p, f, R(0x1.555555555556bp-2));
#else
    real p = R(0x1.13c2dcp-4f);
    p = fma(p, f, R(-0x1.dda1f8p-4f));
    p = fma(p, f, R(0x1.e6dfcap-4f));
    p = fma(p, f, R(-0x1.fc3d24p-4f));
    p = fma(p, f, R(0x1.233abep-3f));
    p = fma(p, f, R(-0x1.555b9p-3f));
    p = fma(p, f, R(0x1.99a47ap-3f));
    p = fma(p, f, R(-0x1.000008p-2f));
    p = fma(p, f, R(0x1.555548p-2f));
#endif
    return p;
}

static inline real pelage_log(real x) {
    x = pelage_flushed(x);
    const struct pelage_parts parts = pelage_parts_around_one(x);
    const real f = parts.mantissa - R(1);
    const real square = f * f;
    const real tail = fma(square * f, pelage_log_tail(f), R(-0.5f) * square);
    const struct pelage_pair sum = pelage_quick_sum(parts.exponent * LN2_HIGH, f);
    const real found = sum.high + (sum.low + fma(parts.exponent, LN2_LOW, tail));
    const real of_rest = SELECT(x == R(0), -INFINITE, SELECT(x < R(0), R(NAN), x));  // infinite, NaN: x
    return SELECT((x > R(0)) & (x < INFINITE), found, of_rest);
}
