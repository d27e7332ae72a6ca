//@ function tanh x | needs power, quotient
// E / (E + 2) of E = e^(2 |x|) - 1.
static inline real pelage_tanh(real x) {
    x = pelage_flushed(x);
    const real size = pelage_size(x);
    const real held = SELECT(size > PICK(10.0f, 20.0), PICK(10.0f, 20.0), size);
    const struct pelage_power power = pelage_power(held + held, R(0));
    const real scale = pelage_power_of_two(power.exponent);
    struct pelage_pair e = pelage_quick_sum(scale - R(1), scale * power.more.high);
    e.low = fma(scale, power.more.low, e.low);
    struct pelage_pair below = pelage_sum(e.high, R(2));
    below.low += e.low;
    const struct pelage_pair found = pelage_quotient(e, below);
    return SELECT(size < PICK(0x1p-12f, 0x1p-27), x, pelage_signed(found.high + found.low, pelage_sign(x)));
}
