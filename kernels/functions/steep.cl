//@ part | needs power, quotient
// Sums and differences of powers of e.

// e^size + e^-size is value 2^exponent, size >= 0; with the sign bit in `down` e^size - e^-size is.
struct pelage_powers {
    real value, exponent;
};

static inline struct pelage_powers pelage_powers(real size, bitsv down) {
    const struct pelage_power power = pelage_power(pelage_not_steep(size), R(0));
    const struct pelage_pair y = pelage_one_more(power.more);
    struct pelage_pair one;
    one.high = R(1);
    one.low = R(0);
    const struct pelage_pair inverse = pelage_quotient(one, y);
    const real shrunk = R(-2) * SELECT(power.exponent > R(30), R(30), power.exponent);
    const real scale = pelage_signed(pelage_power_of_two(shrunk), down);
    const struct pelage_pair both = pelage_sum(y.high, scale * inverse.high);
    struct pelage_powers found;
    found.value = both.high + (both.low + fma(scale, inverse.low, y.low));
    found.exponent = power.exponent;
    return found;
}
