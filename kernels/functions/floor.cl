//@ function floor x | needs numbers
static inline real pelage_floor(real x) { return floor(pelage_flushed(x)); }
