//@ function smoothstep low, high, x | needs numbers
// 3 t^2 - 2 t^3 of t = (x - low) / (high - low), which is held between 0 and 1.
static inline real pelage_smoothstep(real low, real high, real x) {
    low = pelage_flushed(low);
    const real t = (pelage_flushed(x) - low) / (pelage_flushed(high) - low);
    const real held = HELD(t, R(0), R(1));
    return pelage_flushed(held * held) * fma(R(-2), held, R(3));
}
