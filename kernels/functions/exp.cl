//@ function exp x | needs power
static inline real pelage_exp(real x) {
    const struct pelage_power power = pelage_power(pelage_not_steep(x), R(0));
    const struct pelage_pair y = pelage_one_more(power.more);
    return pelage_scaled(y.high + y.low, power.exponent);
}
