//@ function mod a, b
// Of the sign of b.
static inline real pelage_mod(real a, real b) { return a - b * floor(a / b); }
