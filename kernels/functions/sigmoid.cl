//@ function sigmoid x | needs power, quotient
// With e = e^-|x|: 1 / (1 + e), for negative x e / (1 + e).
static inline real pelage_sigmoid(real x) {
    const struct pelage_power power = pelage_power(pelage_not_steep(-pelage_size(x)), R(0));
    const struct pelage_pair y = pelage_one_more(power.more);
    const real scale = pelage_power_of_two(SELECT(power.exponent < R(-64), R(-64), power.exponent));
    struct pelage_pair below = pelage_quick_sum(R(1), scale * y.high);
    below.low = fma(scale, y.low, below.low);
    const mask falls = x < R(0);
    struct pelage_pair above;
    above.high = SELECT(falls, y.high, R(1));
    above.low = SELECT(falls, y.low, R(0));
    const struct pelage_pair found = pelage_quotient(above, below);
    const real value = found.high + found.low;
    return SELECT(falls, pelage_scaled(value, power.exponent), value);
}
