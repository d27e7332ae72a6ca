//@ function clamp x, low, high | needs min, max
// A NaN stays one; where low > high the result is high.
static inline real pelage_clamp(real x, real low, real high) { return pelage_min(pelage_max(x, low), high); }
