//@ function clamp x, low, high | needs numbers
// min(max(x, low), high), each argument flushed once. A NaN stays one; where low > high the result is high.
static inline real pelage_clamp(real x, real low, real high) {
    x = pelage_flushed(x);
    low = pelage_flushed(low);
    high = pelage_flushed(high);
    const real raised = SELECT(low > x, low, x);
    return SELECT(high < raised, high, raised);
}
