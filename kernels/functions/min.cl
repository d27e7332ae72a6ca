//@ function min a, b
// a where they are equal or one of them is NaN.
static inline real pelage_min(real a, real b) { return SELECT(b < a, b, a); }
