//@ function mod a, b | needs numbers
// Of the sign of b.
static inline real pelage_mod(real a, real b) {
    a = pelage_flushed(a);
    b = pelage_flushed(b);
    return a - b * floor(pelage_flushed(a / b));
}
