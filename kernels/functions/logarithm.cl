//@ part | needs numbers
// A positive number as 2^exponent times a number around 1.

struct pelage_parts {
    real mantissa, exponent;
};

// x = mantissa 2^exponent, with the mantissa from sqrt(1/2) to sqrt(2), for positive normal x; in double precision
// subnormal ones, too.
static inline struct pelage_parts pelage_parts_around_one(real x) {
#ifdef PELAGE_DOUBLE
    const mask small = x < SMALLEST;
    const real lifted = SELECT(small, R(54), R(0));
    x = SELECT(small, x * R(0x1p54), x);
#else
    const real lifted = R(0);
#endif
    const bitsv root_of_half = WORD(0x3f3504f3u, 0x3fe6a09e667f3bcdul);
    const bitsv above = AS_BITS(x) - root_of_half;
    const bitsv fraction = above & ((WORD(1u, 1ul) << FRACTION_BITS) - WORD(1u, 1ul));
    // The exponent may be below 0: it is counted from a bias.
    const bitsv biased = (above + (ONE_BITS << 1)) >> FRACTION_BITS;
    const real bias = PICK(254.0f, 2046.0);
    struct pelage_parts parts;
    parts.mantissa = AS_NUMBER(fraction + root_of_half);
    parts.exponent = (AS_NUMBER(WHOLE_SHIFT_BITS + biased) - WHOLE_SHIFT) - (bias + lifted);
    return parts;
}
