//@ function round x | needs numbers
// Halves go away from 0.
static inline real pelage_round(real x) {
    const real size = pelage_size(pelage_flushed(x));
    const real below = floor(size);
    return pelage_signed(SELECT(size - below >= R(0.5f), below + R(1), below), pelage_sign(x));
}
