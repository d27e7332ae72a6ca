// What two neighbours exchange in a time step dt.

// The harmonic mean of their rates; equal rates are that rate, 0 and 0 too.
static inline real pelage_shared_rate(real own, real theirs) {
    return SELECT(own == theirs, own, (R(2) * (own * theirs)) / (own + theirs));
}

// The new value n with what comes at rate e from a neighbour of that share.
#ifdef PELAGE_PUBLISHED
#define FLOW(n, e, share, difference) ((n) + (((e) * (difference)) * dt))
#else
#define FLOW(n, e, share, difference) fma(((e) * dt) * (share), difference, n)
#endif
