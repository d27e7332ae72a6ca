//@ function mix a, b, t
// a at t = 0, b - a rounded and added to a at t = 1.
static inline real pelage_mix(real a, real b, real t) { return fma(b - a, t, a); }
