//@ part | needs numbers
// Far angles: M. Payne and R. Hanek, "Radian reduction for trigonometric functions" (SIGNUM Newsletter, 1983), in whole
// numbers. An angle is m 2^e with whole m; of 2/pi only those 192 bits count that, times m 2^e, are no multiples of 4
// and no less than any angle needs.

#ifdef PELAGE_DOUBLE
#define FAR_WORD(x) as_ulong(x)
#define FAR_BIAS 1023u
#else
#define FAR_WORD(x) ((ulong)as_uint(x))
#define FAR_BIAS 127u
#endif

// 64 bits of 0, and the bits of 2/pi after its point.
constant ulong pelage_two_over_pi[20] = {
    0x0000000000000000ul, 0xa2f9836e4e441529ul, 0xfc2757d1f534ddc0ul, 0xdb6295993c439041ul, 0xfe5163abdebbc561ul,
    0xb7246e3a424dd2e0ul, 0x06492eea09d1921cul, 0xfe1deb1cb129a73eul, 0xe88235f52ebb4484ul, 0xe99c7026b45f7e41ul,
    0x3991d639835339f4ul, 0x9c845f8bbdf9283bul, 0x1ff897ffde05980ful, 0xef2f118b5a0a6d1ful, 0x6d367ecf27cb09b7ul,
    0x4f463f669e5fea2dul, 0x7527bac7ebe5f17bul, 0x3d0739f78a5292eaul, 0x6bfb5fb11f8d5d08ul, 0x56033046fc7b6babul};

// 64 bits of it from bit `first` on. Shifts of two words together are written as products: of shifts a compiler makes
// an instruction that Oclgrind lacks.
static inline ulong pelage_turn_bits(uint first) {
    const uint at = first / 64u;
    const ulong shift = (ulong)1 << (first & 63u);
    return pelage_two_over_pi[at] * shift + mul_hi(pelage_two_over_pi[at + 1u], shift);
}

// f0 2^-62 + f1 2^-126 in two parts, cut into numbers of as many bits as a scalar has.
static inline void pelage_far_parts(ulong f0, ulong f1, scalar* high, scalar* low) {
#ifdef PELAGE_DOUBLE
    const scalar first = (scalar)(f0 >> 9) * 0x1p-53;
    const scalar second = (scalar)(f0 & 0x1fful) * 0x1p-62;
    const scalar third = (scalar)(f1 >> 11) * 0x1p-115;
    const scalar fourth = (scalar)(f1 & 0x7fful) * 0x1p-126;
#else
    const scalar first = (scalar)(f0 >> 38) * 0x1p-24f;
    const scalar second = (scalar)(f0 >> 14 & 0xfffffful) * 0x1p-48f;
    const scalar third = (scalar)(f0 & 0x3ffful) * 0x1p-62f;
    const scalar fourth = 0.0f;
#endif
    const scalar sum = first + second;
    const scalar rest = (second - (sum - first)) + third;
    *high = sum + rest;
    *low = (rest - (*high - sum)) + fourth;
}

// size = (quarters + high + low) pi/2, with high between -1/2 and 1/2 and quarters from 0 to 4, less multiples of 4, for
// finite size > 1.
static inline void pelage_far_turn(scalar size, scalar* high, scalar* low, scalar* quarters) {
    const ulong word = FAR_WORD(size);
    const uint first = (uint)(word >> FRACTION_BITS) - FAR_BIAS - FRACTION_BITS + 62u;
    const ulong m = (word & (((ulong)1 << FRACTION_BITS) - 1ul)) | (ulong)1 << FRACTION_BITS;
    // 128 bits of the product; the first two of them are the quarters.
    const ulong middle = pelage_turn_bits(first + 64u);
    const ulong carried = mul_hi(m, pelage_turn_bits(first + 128u));
    const ulong p1 = m * middle + carried;
    const ulong p0 = m * pelage_turn_bits(first) + mul_hi(m, middle) + (p1 < carried ? 1ul : 0ul);
    const bool more = (p0 >> 61 & 1ul) != 0ul;  // than half a quarter: count from the next one
    const ulong fraction = 0x3ffffffffffffffful;
    pelage_far_parts((more ? ~p0 : p0) & fraction, more ? ~p1 : p1, high, low);
    *high = more ? -*high : *high;
    *low = more ? -*low : *low;
    *quarters = (scalar)(uint)((p0 >> 62) + (more ? 1ul : 0ul));
}
