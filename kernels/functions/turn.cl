//@ part | needs far_turn
// Sine and cosine of an angle less its multiples of pi/2.

struct pelage_angle {
    struct pelage_pair sine, cosine;  // of what is left
    bitsv quarters;                   // the multiple; its last two bits count
};

// (sin(r) - r) / r^3 and (cos(r) - 1 + r^2 / 2) / r^4 of z = r^2, |r| < 0.79: minimax.
static inline real pelage_sine_tail(real z) {
#ifdef PELAGE_DOUBLE
    real p = R(-0x1.a5decc7e94758p-41);
    p = fma(p, z, R(0x1.61159b360f658p-33));
    p = fma(p, z, R(-0x1.ae643ea2e69ecp-26));
    p = fma(p, z, R(0x1.71de3a4104cd4p-19));
    p = fma(p, z, R(-0x1.a01a01a00769cp-13));
    p = fma(p, z, R(0x1.111111111108dp-7));
    p = fma(p, z, R(-0x1.5555555555555p-3));
#else
    real p = R(0x1.772d18p-19f);
    p = fma(p, z, R(-0x1.a045f2p-13f));
    p = fma(p, z, R(0x1.111162p-7f));
    p = fma(p, z, R(-0x1.555556p-3f));
#endif
    return p;
}
static inline real pelage_cosine_tail(real z) {
#ifdef PELAGE_DOUBLE
    real p = R(-0x1.8f8e0900a589fp-37);
    p = fma(p, z, R(0x1.1ee9ac2468b4p-29));
    p = fma(p, z, R(-0x1.27e4f7aa91f51p-22));
    p = fma(p, z, R(0x1.a01a019c2afb3p-16));
    p = fma(p, z, R(-0x1.6c16c16c14bf4p-10));
    p = fma(p, z, R(0x1.5555555555549p-5));
#else
    real p = R(0x1.99df46p-16f);
    p = fma(p, z, R(-0x1.6c0c16p-10f));
    p = fma(p, z, R(0x1.55554ap-5f));
#endif
    return p;
}

// Cody and Waite, as in power.cl: exact for angles up to some ten thousand turns.
static inline struct pelage_pair pelage_near_turn(real size, real quarters) {
    const real rest = fma(-quarters, HALF_PI, size);  // exact
    const struct pelage_pair second = pelage_product(quarters, HALF_PI_LOW);
    const struct pelage_pair left = pelage_sum(rest, -second.high);
    const real third = PICK(-0x1.ee59dap-50f, -0x1.f1976b7ed8fbcp-110);
    return pelage_quick_sum(left.high, fma(-quarters, third, left.low - second.low));
}

// Lane by lane; those that are not far keep what they have.
static inline struct pelage_pair pelage_all_turns(real size, mask far, struct pelage_pair rest, real* quarters) {
    scalar sizes[PELAGE_WIDTH], highs[PELAGE_WIDTH], lows[PELAGE_WIDTH], wholes[PELAGE_WIDTH];
    STORE(SELECT(far & (size < INFINITE), size, R(2)), sizes);
    for (int lane = 0; lane < PELAGE_WIDTH; ++lane)
        pelage_far_turn(sizes[lane], highs + lane, lows + lane, wholes + lane);
    const real high = LOAD(highs);
    const real low = LOAD(lows);
    const struct pelage_pair product = pelage_product(high, HALF_PI);
    const real second = fma(high, HALF_PI_LOW, low * HALF_PI);
    const struct pelage_pair found = pelage_quick_sum(product.high, product.low + second);
    rest.high = SELECT(far, SELECT(size < INFINITE, found.high, R(NAN)), rest.high);
    rest.low = SELECT(far, found.low, rest.low);
    *quarters = SELECT(far, LOAD(wholes), *quarters);
    return rest;
}

// For size >= 0; what is infinite has no angle.
static inline struct pelage_angle pelage_angle(real size) {
    real quarters = NEAREST(size * PICK(0x1.45f306p-1f, 0x1.45f306dc9c883p-1));
    struct pelage_pair r = pelage_near_turn(size, quarters);
    const mask far = size > PICK(65536.0f, 4194304.0);
    if (ANY(far)) r = pelage_all_turns(size, far, r, &quarters);

    struct pelage_angle angle;
    angle.quarters = WHOLE_BITS(quarters);
    const real z = r.high * r.high;
    const real z_low = fma(r.high, r.high, -z);
    const real bend = r.low * fma(z, R(-0.5f), R(1));
    angle.sine = pelage_quick_sum(r.high, fma(z * r.high, pelage_sine_tail(z), bend));
    const real w = R(1) - R(0.5f) * z;
    const real lost = ((R(1) - w) - R(0.5f) * z) - fma(r.high, r.low, R(0.5f) * z_low);
    angle.cosine = pelage_quick_sum(w, fma(z * z, pelage_cosine_tail(z), lost));
    return angle;
}

// Truth where the multiple is odd; the sign bit where its second bit is set.
#define IS_ODD(quarters) (((quarters) & WORD(1u, 1ul)) != WORD(0u, 0ul))
#define HALF_TURN_SIGN(quarters) (((quarters) << (FRACTION_BITS == 52 ? 62 : 30)) & SIGN_BIT)
