// What a device can do at most: copy, and multiply and add. Measured by `pelage bench`, beside what the solvers reach.

__kernel void pelage_copy(__global const float16* restrict from, __global float16* restrict to, uint count) {
    const uint i = get_global_id(0);
    if (i < count) to[i] = from[i];
}

// Eight chains of fma an item, so that none waits for another: 8 x 16 x 2 operations a round.
__kernel void pelage_multiply_add(__global float* restrict sums, int rounds) {
    const uint item = get_global_id(0);
    const float16 a = 0.999f;
    const float16 b = 0.25f;
    float16 s0 = item, s1 = item + 1, s2 = item + 2, s3 = item + 3;
    float16 s4 = item + 4, s5 = item + 5, s6 = item + 6, s7 = item + 7;
    for (int round = 0; round < rounds; ++round) {
        s0 = fma(s0, a, b);
        s1 = fma(s1, a, b);
        s2 = fma(s2, a, b);
        s3 = fma(s3, a, b);
        s4 = fma(s4, a, b);
        s5 = fma(s5, a, b);
        s6 = fma(s6, a, b);
        s7 = fma(s7, a, b);
    }
    const float16 s = ((s0 + s1) + (s2 + s3)) + ((s4 + s5) + (s6 + s7));
    const float8 h = s.lo + s.hi;
    const float4 q = h.lo + h.hi;
    const float2 d = q.lo + q.hi;
    sums[item] = d.x + d.y;
}
