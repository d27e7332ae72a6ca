//@ function step edge, x | needs numbers
// 0 for x < edge, else 1.
static inline real pelage_step(real edge, real x) {
    return SELECT(pelage_flushed(x) < pelage_flushed(edge), R(0), R(1));
}
