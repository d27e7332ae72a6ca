//@ part | needs numbers
// Powers of e: W. Cody and W. Waite, Software Manual for the Elementary Functions (1980), reduction by multiples of ln 2.

// e^(x + low) = (1 + high + low) 2^exponent, with -0.3 < high < 0.42.
struct pelage_power {
    struct pelage_pair more;
    real exponent;
};

// (e^r - 1 - r) / r^2, |r| < 0.3466: minimax.
static inline real pelage_power_tail(real r) {
#ifdef PELAGE_DOUBLE
    real p = R(0x1.1eed10ba3ff62p-29);
    p = fma(p, r, R(0x1.af6e5bd233d8fp-26));
    p = fma(p, r, R(0x1.27e5339dbae4cp-22));
    p = fma(p, r, R(0x1.71ddee863632bp-19));
    p = fma(p, r, R(0x1.a01a017d48c66p-16));
    p = fma(p, r, R(0x1.a01a01b43e1c9p-13));
    p = fma(p, r, R(0x1.6c16c16c1e5bdp-10));
    p = fma(p, r, R(0x1.111111110ea06p-7));
    p = fma(p, r, R(0x1.5555555555544p-5));
    p = fma(p, r, R(0x1.555555555555cp-3));
    p = fma(p, r, R(0x1.0p-1));
#else
    real p = R(0x1.9a981p-13f);
    p = fma(p, r, R(0x1.6d5146p-10f));
    p = fma(p, r, R(0x1.1115b4p-7f));
    p = fma(p, r, R(0x1.5554e4p-5f));
    p = fma(p, r, R(0x1.555552p-3f));
    p = fma(p, r, R(0x1.0p-1f));
#endif
    return p;
}

// |x| < 174 (1400); |low| is at most about a rounding error of x.
static inline struct pelage_power pelage_power(real x, real low) {
    const real k = NEAREST(x * PICK(0x1.715476p+0f, 0x1.71547652b82fep+0));
    const real near = fma(-k, LN2_HIGH, x);  // exact
    const real r = fma(-k, LN2_LOW, near);
    const real rest = fma(-k, LN2_LOW, near - r) + low;
    const real tail = (r * r) * pelage_power_tail(r);
    struct pelage_power power;
    power.exponent = k;
    power.more.high = r + tail;
    power.more.low = ((r - power.more.high) + tail) + fma(rest, power.more.high, rest);
    return power;
}

// 1 + s for -0.3 < s < 0.42.
static inline struct pelage_pair pelage_one_more(struct pelage_pair s) {
    struct pelage_pair y;
    y.high = R(1) + s.high;
    y.low = ((R(1) - y.high) + s.high) + s.low;
    return y;
}

// x where |x| < PELAGE_STEEP, else that bound with its sign: beyond, every power of e is 0 or infinite.
#define PELAGE_STEEP PICK(106.0f, 750.0)
static inline real pelage_not_steep(real x) { return HELD(x, -PELAGE_STEEP, PELAGE_STEEP); }
