//@ function max a, b
// a where they are equal or one of them is NaN.
static inline real pelage_max(real a, real b) { return SELECT(a < b, b, a); }
