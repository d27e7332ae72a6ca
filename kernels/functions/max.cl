//@ function max a, b | needs numbers
// a where they are equal or one of them is NaN.
static inline real pelage_max(real a, real b) {
    a = pelage_flushed(a);
    b = pelage_flushed(b);
    return SELECT(a < b, b, a);
}
