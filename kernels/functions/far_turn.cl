//@ part | needs numbers
// Far angles: M. Payne and R. Hanek, "Radian reduction for trigonometric functions" (SIGNUM Newsletter, 1983), in whole
// numbers. An angle is m 2^e with whole m; of 2/pi only those 192 bits count that, times m 2^e, are no multiples of 4
// and no less than any angle needs.

#ifdef PELAGE_DOUBLE
#define FAR_WORD(x) as_ulong(x)
#define FAR_PART(f0, f1) (((f0) << 42 | (f1) >> 22) & 0x1ffffffffffffful)
#define FAR_POWER(n) as_double((ulong)(1023 - (n)) << 52)  // 2^-n
#else
#define FAR_WORD(x) ((ulong)as_uint(x))
#define FAR_PART(f0, f1) ((f0) >> 16 & 0xfffffful)
#define FAR_POWER(n) as_float((uint)(127 - (n)) << 23)
#endif
#define FAR_BIAS (FRACTION_BITS == 52 ? 1023 : 127)

// 64 bits of 0, and the bits of 2/pi after its point.
constant ulong pelage_two_over_pi[20] = {
    0x0000000000000000ul, 0xa2f9836e4e441529ul, 0xfc2757d1f534ddc0ul, 0xdb6295993c439041ul, 0xfe5163abdebbc561ul,
    0xb7246e3a424dd2e0ul, 0x06492eea09d1921cul, 0xfe1deb1cb129a73eul, 0xe88235f52ebb4484ul, 0xe99c7026b45f7e41ul,
    0x3991d639835339f4ul, 0x9c845f8bbdf9283bul, 0x1ff897ffde05980ful, 0xef2f118b5a0a6d1ful, 0x6d367ecf27cb09b7ul,
    0x4f463f669e5fea2dul, 0x7527bac7ebe5f17bul, 0x3d0739f78a5292eaul, 0x6bfb5fb11f8d5d08ul, 0x56033046fc7b6babul};

// 64 bits of it from bit `first` on.
static inline ulong pelage_turn_bits(uint first) {
    const uint at = first / 64u;
    const uint within = first & 63u;
    const ulong high = pelage_two_over_pi[at] << within;
    return within == 0u ? high : high | pelage_two_over_pi[at + 1u] >> (64u - within);
}

// size = (quarters + high + low) pi/2, with high between -1/2 and 1/2 and quarters from 0 to 4, less multiples of 4, for
// finite size > 1. The parts are numbers of their own: low is the bits that follow those of high.
static inline void pelage_far_turn(scalar size, scalar* high, scalar* low, scalar* quarters) {
    const ulong word = FAR_WORD(size);
    const uint first = (uint)(word >> FRACTION_BITS) - FAR_BIAS - FRACTION_BITS + 62u;
    const ulong m = (word & (((ulong)1 << FRACTION_BITS) - 1ul)) | (ulong)1 << FRACTION_BITS;
    // The lowest 192 bits of the product; the first two of them are the quarters.
    const ulong middle = pelage_turn_bits(first + 64u);
    const ulong last = pelage_turn_bits(first + 128u);
    const ulong p1 = m * middle + mul_hi(m, last);
    const ulong p0 = m * pelage_turn_bits(first) + mul_hi(m, middle) + (p1 < mul_hi(m, last) ? 1ul : 0ul);
    ulong f0 = p0 << 2 | p1 >> 62;
    ulong f1 = p1 << 2 | (m * last) >> 62;
    const bool more = f0 >> 63 != 0ul;  // than half a quarter: count from the next one
    if (more) {
        f0 = ~f0;
        f1 = ~f1;
    }
    const uint zeros = (uint)clz(f0);
    if (zeros != 0u) f0 = f0 << zeros | f1 >> (64u - zeros);
    f1 <<= zeros;
    const scalar unit = FAR_POWER(zeros + FRACTION_BITS + 1u);
    const scalar sign = more ? -unit : unit;
    *high = (scalar)(f0 >> (63 - FRACTION_BITS)) * sign;
    *low = (scalar)FAR_PART(f0, f1) * (sign * FAR_POWER(FRACTION_BITS + 1u));
    *quarters = (scalar)(uint)((p0 >> 62) + (more ? 1ul : 0ul));
}
