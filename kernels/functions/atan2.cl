//@ function atan2 y, x | needs arc, logarithm
// Of the tangent, when the arc is the tangent; and where that is 0 at the latest.
#define TINY_EXPONENT PICK(-40.0f, -80.0)
#define LEAST_EXPONENT PICK(-200.0f, -1200.0)

// The arc of less / more, taken from `quarters`; 0 <= less <= more, no NaN.
static inline real pelage_arc_of(real less, real more, real quarters, bitsv down) {
    const struct pelage_parts above = pelage_parts_around_one(less);
    const struct pelage_parts below = pelage_parts_around_one(more);
    const real exponent = above.exponent - below.exponent;
    const mask tiny = exponent < TINY_EXPONENT;
    const real scale = pelage_power_of_two(SELECT(tiny, TINY_EXPONENT, exponent));
    struct pelage_ratio ratio = pelage_ratio(above.mantissa, scale, below.mantissa);
    const real least = SELECT(exponent < LEAST_EXPONENT, LEAST_EXPONENT, exponent);
    const real small = pelage_scaled(ratio.tangent.high + ratio.tangent.low, least);
    const mask none = (less == R(0)) | ((more == INFINITE) & (less < INFINITE));
    const mask equal = (less == more) & !none;
    ratio.middle = (ratio.middle | equal) & !none;
    const real unscaled = SELECT(ratio.middle, R(1), scale);
    ratio.tangent.high = SELECT(none | equal, R(0), ratio.tangent.high * unscaled);
    ratio.tangent.low = SELECT(none | equal, R(0), ratio.tangent.low * unscaled);
    const real arc = pelage_arc_from(quarters, ratio, down);
    return SELECT((tiny & !none) & (quarters == R(0)), small, arc);
}

static inline real pelage_atan2(real y, real x) {
    const real up = pelage_size(pelage_flushed(y));
    const real along = pelage_size(pelage_flushed(x));
    const mask steep = up > along;
    const mask left = pelage_sign(x) != WORD(0u, 0ul);
    const real quarters = SELECT(steep, R(1), SELECT(left, R(2), R(0)));
    const bitsv down = SELECT(left != steep, SIGN_BIT, WORD(0u, 0ul));
    const real arc = pelage_arc_of(SELECT(steep, along, up), SELECT(steep, up, along), quarters, down);
    return SELECT((x != x) | (y != y), x + y, pelage_signed(arc, pelage_sign(y)));
}
