//@ function cos x | needs turn
static inline real pelage_cos(real x) {
    const struct pelage_angle angle = pelage_angle(pelage_size(pelage_flushed(x)));
    const real found = SELECT(IS_ODD(angle.quarters), angle.sine.high, angle.cosine.high);
    return pelage_signed(found, HALF_TURN_SIGN(angle.quarters + WORD(1u, 1ul)));
}
