//@ function step edge, x
// 0 for x < edge, else 1.
static inline real pelage_step(real edge, real x) { return SELECT(x < edge, R(0), R(1)); }
