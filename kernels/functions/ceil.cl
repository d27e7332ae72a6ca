//@ function ceil x | needs numbers
static inline real pelage_ceil(real x) { return ceil(pelage_flushed(x)); }
