//@ function cosh x | needs steep
static inline real pelage_cosh(real x) {
    const struct pelage_powers powers = pelage_powers(pelage_size(x), WORD(0u, 0ul));
    return pelage_scaled(powers.value, powers.exponent - R(1));
}
