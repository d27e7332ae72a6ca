//@ function acos x | needs arc_sine
static inline real pelage_acos(real x) {
    x = pelage_flushed(x);
    const real size = pelage_size(x);
    const mask beyond = size >= R(0.5f);
    const bitsv sign = pelage_sign(x);
    const struct pelage_pair arc = pelage_arc_sine(size, beyond);
    const real high = SELECT(beyond, R(2) * arc.high, -pelage_signed(arc.high, sign));
    const real low = SELECT(beyond, R(2) * arc.low, -pelage_signed(arc.low, sign));
    // Near: pi/2 less the arc; far: twice the arc, or pi less that.
    const mask turned = beyond & (x < R(0));
    const real base = SELECT(turned, R(2) * HALF_PI, SELECT(beyond, R(0), HALF_PI));
    const real base_low = SELECT(turned, R(2) * HALF_PI_LOW, SELECT(beyond, R(0), HALF_PI_LOW));
    const struct pelage_pair total = pelage_quick_sum(base, SELECT(turned, -high, high));
    const real found = total.high + (total.low + (base_low + SELECT(turned, -low, low)));
    return SELECT(size > R(1), R(NAN), found);
}
