// Philox4x32-10 (Salmon, Moraes, Dror & Shaw 2011): random numbers by counter, the same whatever the order of work.

struct pelage_words {
    uintv x, y, z, w;
};

// The upper words of products with m. Vectors: by way of 64 bits, for which processors have instructions; PoCL takes
// mul_hi lane by lane.
#if PELAGE_WIDTH > 1
typedef PELAGE_PASTE(ulong, PELAGE_WIDTH) pelage_wide;
#ifdef __clang__
#define TO_WIDE(v) __builtin_convertvector(v, pelage_wide)
#define TO_UINTV(v) __builtin_convertvector(v, uintv)
#else
#define TO_WIDE(v) PELAGE_PASTE(convert_ulong, PELAGE_WIDTH)(v)
#define TO_UINTV(v) PELAGE_PASTE(convert_uint, PELAGE_WIDTH)(v)
#endif
static inline uintv pelage_upper(uintv v, uint m) {
    const pelage_wide product = TO_WIDE(v) * (pelage_wide)((ulong)m);
    return TO_UINTV(product >> (pelage_wide)(32ul));
}
#else
#define pelage_upper(v, m) mul_hi(v, (uint)(m))
#endif

static inline struct pelage_words pelage_philox4x32_10(uintv x, uintv y, uintv z, uintv w, uint key0, uint key1) {
    struct pelage_words c = {x, y, z, w};
    for (int round = 0; round < 10; ++round) {
        const uintv high0 = pelage_upper(c.x, 0xD2511F53u);
        const uintv low0 = (uintv)(0xD2511F53u) * c.x;
        const uintv high1 = pelage_upper(c.z, 0xCD9E8D57u);
        const uintv low1 = (uintv)(0xCD9E8D57u) * c.z;
        c.x = high1 ^ c.y ^ (uintv)(key0);
        c.y = low1;
        c.z = high0 ^ c.w ^ (uintv)(key1);
        c.w = low0;
        key0 += 0x9E3779B9u;
        key1 += 0xBB67AE85u;
    }
    return c;
}

// Counter (cell, iteration, rule, purpose), key (low, high) word of the seed; see core/philox.hpp.
#define DRAW(cell, iteration, rule, purpose, low, high) \
    pelage_philox4x32_10(cell, (uintv)(iteration), (uintv)(rule), (uintv)(purpose), low, high)

// Uniform in [0, 1) from the upper 24 bits: exact in float and double alike.
#define UNIT(word) (TO_REAL((word) >> 8) * R((scalar)0x1p-24f))
