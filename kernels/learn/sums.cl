// Long sums of learning in an order of their own, as core/learning.hpp says: so many partial sums side by side.
#define PELAGE_LANES 16
#define PELAGE_PARTS (PELAGE_LANES / PELAGE_WIDTH)  // vectors that hold them

// `count`, a power of two, partial sums become one.
static inline scalar pelage_folded(scalar* lanes, const int count) {
    for (int middle = count / 2; middle > 0; middle /= 2) {
        for (int lane = 0; lane < middle; ++lane) lanes[lane] = lanes[lane] + lanes[lane + middle];
    }
    return lanes[0];
}

// All of them, which a group of work-items has left there.
static inline scalar pelage_folded_shared(local const scalar* shared) {
    scalar lanes[PELAGE_LANES];
    for (int lane = 0; lane < PELAGE_LANES; ++lane) lanes[lane] = shared[lane];
    return pelage_folded(lanes, PELAGE_LANES);
}

// The same of vectors.
static inline scalar pelage_folded_parts(const real* parts, const int count) {
    scalar lanes[2 * PELAGE_LANES];
    for (int part = 0; part < count; ++part) STORE(parts[part], lanes + part * PELAGE_WIDTH);
    return pelage_folded(lanes, count * PELAGE_WIDTH);
}
