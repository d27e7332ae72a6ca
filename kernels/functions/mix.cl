//@ function mix a, b, t | needs numbers
// a at t = 0, and at t = 1 a + (b - a) as it is rounded. Without fma: rusticl's loses the sign of 0.
static inline real pelage_mix(real a, real b, real t) {
    a = pelage_flushed(a);
    return a + (pelage_flushed(b) - a) * pelage_flushed(t);
}
