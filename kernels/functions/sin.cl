//@ function sin x | needs turn
static inline real pelage_sin(real x) {
    x = pelage_flushed(x);
    const struct pelage_angle angle = pelage_angle(pelage_size(x));
    const real found = SELECT(IS_ODD(angle.quarters), angle.cosine.high, angle.sine.high);
    return pelage_signed(found, HALF_TURN_SIGN(angle.quarters) ^ pelage_sign(x));
}
