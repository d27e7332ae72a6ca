//@ function asin x | needs arc_sine
static inline real pelage_asin(real x) {
    x = pelage_flushed(x);
    const real size = pelage_size(x);
    const mask beyond = size >= R(0.5f);
    const struct pelage_pair arc = pelage_arc_sine(size, beyond);
    const struct pelage_pair rest = pelage_quick_sum(HALF_PI, R(-2) * arc.high);
    const real far = rest.high + (rest.low + fma(R(-2), arc.low, HALF_PI_LOW));
    const real found = pelage_signed(SELECT(beyond, far, arc.high + arc.low), pelage_sign(x));
    return SELECT(size > R(1), R(NAN), found);
}
