//@ part
// What elementary functions are made of: bits of numbers, powers of two, sums and products with their rounding errors.
// A function has the same bits on every device: it adds, multiplies, compares and uses fma, rint and whole numbers, but no
// division and no square root, which devices round as they like. Each file has its like in reference/functions; both
// have the same parentheses.

// bitsv: a number's bits as a whole number, a lane each. PICK: a constant of either precision.
#ifdef PELAGE_DOUBLE
#define PELAGE_LANE_BITS ulong
#define PICK(single, twice) R(twice)
#define WORD(single, twice) ((bitsv)(twice))
#define FRACTION_BITS 52
#else
#define PELAGE_LANE_BITS uint
#define PICK(single, twice) R(single)
#define WORD(single, twice) ((bitsv)(single))
#define FRACTION_BITS 23
#endif
#if PELAGE_WIDTH == 1
typedef PELAGE_LANE_BITS bitsv;
#define AS_BITS(x) PELAGE_PASTE(as_, PELAGE_LANE_BITS)(x)
#define AS_NUMBER(b) PELAGE_PASTE(as_, PELAGE_SCALAR)(b)
#else
typedef PELAGE_PASTE(PELAGE_LANE_BITS, PELAGE_WIDTH) bitsv;
#define AS_BITS(x) PELAGE_PASTE(PELAGE_PASTE(as_, PELAGE_LANE_BITS), PELAGE_WIDTH)(x)
#define AS_NUMBER(b) PELAGE_PASTE(PELAGE_PASTE(as_, PELAGE_SCALAR), PELAGE_WIDTH)(b)
#endif
#define SIGN_BIT WORD(0x80000000u, 0x8000000000000000ul)
#define ONE_BITS WORD(0x3f800000u, 0x3ff0000000000000ul)
#define SMALLEST PICK(0x1p-126f, 0x1p-1022)  // that is normal
#define INFINITE R(INFINITY)

// pi/2 in two parts, ln 2 in two of which the first has so few bits that an exponent times it is exact.
#define HALF_PI PICK(0x1.921fb6p+0f, 0x1.921fb54442d18p+0)
#define HALF_PI_LOW PICK(-0x1.777a5cp-25f, 0x1.1a62633145c07p-54)
#define LN2_HIGH PICK(0x1.62e4p-1f, 0x1.62e42fefa3p-1)
#define LN2_LOW PICK(0x1.7f7d1cp-20f, 0x1.3de6af278ece6p-42)

// The bits of a whole number w, |w| < 2^21, plus this one are w + const: its lowest bits are those of w.
#define WHOLE_SHIFT PICK(0x1.8p+23f, 0x1.8p+52)
#define WHOLE_SHIFT_BITS WORD(0x4b400000u, 0x4338000000000000ul)
#define WHOLE_BITS(w) AS_BITS((w) + WHOLE_SHIFT)

// The nearest whole number, for |x| < 2^21. PoCL's rint takes five times as long; a compiler that may reorder sums would
// drop ours.
#ifdef PELAGE_FAST
#define NEAREST(x) rint(x)
#else
#define NEAREST(x) (((x) + WHOLE_SHIFT) - WHOLE_SHIFT)
#endif

static inline real pelage_size(real x) { return AS_NUMBER(AS_BITS(x) & ~SIGN_BIT); }
static inline bitsv pelage_sign(real x) { return AS_BITS(x) & SIGN_BIT; }
static inline real pelage_signed(real x, bitsv sign) { return AS_NUMBER(AS_BITS(x) ^ sign); }

// Single precision takes subnormal numbers for 0 of their sign.
//   PELAGE_FLUSHED     what comes in is 0 where it would be subnormal: the device's arithmetic has seen to that
static inline real pelage_flushed(real x) {
#if defined(PELAGE_DOUBLE) || defined(PELAGE_FLUSHED)
    return x;
#else
    return SELECT(pelage_size(x) < SMALLEST, AS_NUMBER(pelage_sign(x)), x);
#endif
}

// r 2^k for r in [1/2, 2) and whole k, |k| < 250 (2000); in single precision 0 where that is subnormal.
static inline real pelage_scaled(real r, real k) {
    const bitsv both = WHOLE_BITS(k) - WHOLE_SHIFT_BITS + WORD(256u, 2048ul);
    const bitsv half_of_it = both >> 1;
    const real first = AS_NUMBER((half_of_it - WORD(1u, 1ul)) << FRACTION_BITS);
    const real second = AS_NUMBER((both - half_of_it - WORD(1u, 1ul)) << FRACTION_BITS);
    const real scaled = (r * first) * second;
#ifdef PELAGE_DOUBLE
    return scaled;
#else
    return SELECT(k + SELECT(r < R(1), R(-1), R(0)) < R(-126), R(0), scaled);
#endif
}

// 2^k for whole k whose power is a normal number.
static inline real pelage_power_of_two(real k) {
    return AS_NUMBER((WHOLE_BITS(k) << FRACTION_BITS) + ONE_BITS);
}

// A number in two parts: high + low, where low is at most about a rounding error of high.
struct pelage_pair {
    real high, low;
};

static inline struct pelage_pair pelage_sum(real a, real b) {
    struct pelage_pair s;
    s.high = a + b;
    const real t = s.high - a;
    s.low = (a - (s.high - t)) + (b - t);
    return s;
}

// The same for |a| >= |b|, or a = 0.
static inline struct pelage_pair pelage_quick_sum(real a, real b) {
    struct pelage_pair s;
    s.high = a + b;
    s.low = b - (s.high - a);
    return s;
}

static inline struct pelage_pair pelage_product(real a, real b) {
    struct pelage_pair p;
    p.high = a * b;
    p.low = fma(a, b, -p.high);
    return p;
}
