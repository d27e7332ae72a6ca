//@ part | needs quotient
// Arcs of a tangent.

// (arctan(q) - q) / q^3 of z = q^2, |q| <= tan(pi/8): minimax.
static inline real pelage_arc_tail(real z) {
#ifdef PELAGE_DOUBLE
    real p = R(-0x1.256359424e5eap-6);
    p = fma(p, z, R(0x1.37d287c62948bp-5));
    p = fma(p, z, R(-0x1.9cd18d7209246p-5));
    p = fma(p, z, R(0x1.df0f0aa7dd591p-5));
    p = fma(p, z, R(-0x1.10ebb416c6636p-4));
    p = fma(p, z, R(0x1.3b1118c57d137p-4));
    p = fma(p, z, R(-0x1.745cf8d81ec5dp-4));
    p = fma(p, z, R(0x1.c71c70e5f0464p-4));
    p = fma(p, z, R(-0x1.24924922ad28p-3));
    p = fma(p, z, R(0x1.9999999995866p-3));
    p = fma(p, z, R(-0x1.555555555553dp-2));
#else
    real p = R(-0x1.f2f55ep-5f);
    p = fma(p, z, R(0x1.b2276ep-4f));
    p = fma(p, z, R(-0x1.23b9d4p-3f));
    p = fma(p, z, R(0x1.9991e4p-3f));
    p = fma(p, z, R(-0x1.55554ap-2f));
#endif
    return p;
}

struct pelage_ratio {
    struct pelage_pair tangent;
    mask middle;
};

// less scale / more, 0 <= less scale <= more: below tan(pi/8) less / more itself, without the scale. Else `middle` holds
// and the tangent is that of the arc less pi/4, (less scale - more) / (less scale + more).
static inline struct pelage_ratio pelage_ratio(real less, real scale, real more) {
    struct pelage_ratio ratio;
    const real share = less * scale;
    ratio.middle = share > R(0.4140625f) * more;
    const struct pelage_pair gap = pelage_sum(share, -more);
    const struct pelage_pair both = pelage_sum(share, more);
    struct pelage_pair above, below;
    above.high = SELECT(ratio.middle, gap.high, less);
    above.low = SELECT(ratio.middle, gap.low, R(0));
    below.high = SELECT(ratio.middle, both.high, more);
    below.low = SELECT(ratio.middle, both.low, R(0));
    ratio.tangent = pelage_quotient(above, below);
    return ratio;
}

// quarters pi/2 and, for the middle, pi/4, and the arc of the tangent; where the sign bit is given in `down`, quarters
// pi/2 less the rest.
static inline real pelage_arc_from(real quarters, struct pelage_ratio ratio, bitsv down) {
    const real start = quarters + SELECT(ratio.middle, pelage_signed(R(0.5f), down), R(0));
    const struct pelage_pair base = pelage_product(start, HALF_PI);
    const real z = ratio.tangent.high * ratio.tangent.high;
    const real bend = ratio.tangent.low * (R(1) - z);
    const real tail = fma(ratio.tangent.high, z * pelage_arc_tail(z), bend);
    const struct pelage_pair total = pelage_quick_sum(base.high, pelage_signed(ratio.tangent.high, down));
    return total.high + (total.low + (fma(start, HALF_PI_LOW, base.low) + pelage_signed(tail, down)));
}
