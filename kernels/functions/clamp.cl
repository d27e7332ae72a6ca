//@ function clamp x, low, high
// A NaN stays one; where low > high the result is high.
static inline real pelage_clamp(real x, real low, real high) {
    const real raised = SELECT(x < low, low, x);
    return SELECT(high < raised, high, raised);
}
