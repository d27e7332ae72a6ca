//@ function sqrt x
static inline real pelage_sqrt(real x) { return sqrt(x); }
