//@ function sqrt x | needs numbers
// As the device rounds it: correctly, where it can be told to.
static inline real pelage_sqrt(real x) { return sqrt(pelage_flushed(x)); }
