//@ function abs x | needs numbers
static inline real pelage_abs(real x) { return pelage_size(pelage_flushed(x)); }
